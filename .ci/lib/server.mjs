// A small static server for dist/: right types, strong caching for hashed names, compressed twins, no way out of the folder.
import { createReadStream, existsSync, readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { createServer as createTlsServer } from 'node:https';
import { extname, join, normalize, sep } from 'node:path';
import { Stop } from './run.mjs';

const kTypes = {
  '.css': 'text/css; charset=utf-8',
  '.glb': 'model/gltf-binary',
  '.html': 'text/html; charset=utf-8',
  '.ico': 'image/x-icon',
  '.jpeg': 'image/jpeg',
  '.jpg': 'image/jpeg',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.md': 'text/plain; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.obj': 'model/obj',
  '.png': 'image/png',
  '.stl': 'model/stl',
  '.svg': 'image/svg+xml',
  '.ttf': 'font/ttf',
  '.txt': 'text/plain; charset=utf-8',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
  '.webp': 'image/webp',
  '.woff2': 'font/woff2',
};
/** Requests to the share server that are under way have so long to be answered when the server ends. */
const kAnswerMs = 3000;

const kEncodings = [
  ['br', 'br'],
  ['gzip', 'gz'],
];
// What the build writes: `name-` and a hash of eight base-32 (esbuild) or ten hexadecimal characters.
const kHashed = /-([0-9A-Z]{8}|[0-9a-f]{10})\.[a-z0-9]+$/;

function fileStat(file) {
  try {
    const stat = statSync(file);
    return stat.isFile() ? stat : null;
  } catch {
    return null;
  }
}

/** The file a request path asks for, always inside `folder`; null where there is none. */
function fileFor(folder, requestPath) {
  let path;
  try {
    path = decodeURIComponent(requestPath);
  } catch {
    return null;
  }
  if (path.includes('\0')) return null;
  const file = normalize(join(folder, path.endsWith('/') ? `${path}index.html` : path));
  return file.startsWith(folder + sep) && fileStat(file) ? file : null;
}

function accepts(request, encoding) {
  const offers = String(request.headers['accept-encoding'] ?? '').split(',');
  return offers.some((offer) => {
    const [name, ...rest] = offer.split(';').map((part) => part.trim());
    return name === encoding && !rest.some((part) => /^q=0(\.0*)?$/.test(part));
  });
}

/** The content security policy that a site's page states; as a header it holds for its workers too. Null where there is none. */
function policyOf(folder) {
  const page = join(folder, 'index.html');
  const found =
    existsSync(page) && /http-equiv="Content-Security-Policy" content="([^"]+)"/.exec(readFileSync(page, 'utf8'));
  return found ? found[1] : null;
}

/** What the page is told of its host (web/shell/room/host.ts); a static host sends the file, which names no server. */
const kShareInfo = 'share.json';

/** The share server answers what is its own; true when it did. */
function answeredByShare(request, response, { basePath, share }) {
  if (!share || !request.url.startsWith(`${basePath}share`)) return false;
  const inside = request.url.slice(basePath.length);
  if (inside.startsWith('share/')) {
    request.url = `/${inside}`;
    share.handle(request, response);
    return true;
  }
  if (inside !== kShareInfo) return false;
  const info = JSON.stringify({ server: 'share/v1/', addresses: share.addresses ?? [] });
  response.writeHead(200, { 'Content-Type': kTypes['.json'], 'Cache-Control': 'no-store' });
  response.end(request.method === 'HEAD' ? undefined : info);
  return true;
}

async function answer(request, response, { folder, basePath, isolated, later, policy, share }) {
  if (answeredByShare(request, response, { basePath, share })) return;
  const finish = (status, text) => {
    response.writeHead(status, { 'Content-Type': 'text/plain; charset=utf-8', 'Cache-Control': 'no-cache' });
    response.end(request.method === 'HEAD' ? undefined : text);
  };
  response.setHeader('X-Content-Type-Options', 'nosniff');
  response.setHeader('Cross-Origin-Resource-Policy', 'same-origin');
  if (isolated) {
    response.setHeader('Cross-Origin-Opener-Policy', 'same-origin');
    response.setHeader('Cross-Origin-Embedder-Policy', 'require-corp');
  }
  if (policy) response.setHeader('Content-Security-Policy', policy);
  if (request.method !== 'GET' && request.method !== 'HEAD') return finish(405, 'Only GET and HEAD are answered.\n');
  // Not the URL class: it would resolve `..` before it can be refused.
  const path = request.url.replace(/[?#].*$/, '');
  const inside = path.startsWith(basePath) ? path.slice(basePath.length - 1) : null;
  const made = later?.get(inside?.slice(1));
  if (made) {
    const place = await made;
    if (!place) return finish(503, 'This file could not be made.\n');
    response.writeHead(302, { Location: `${basePath}${place}`, 'Cache-Control': 'no-store' });
    return response.end();
  }
  const file = inside === null ? null : fileFor(folder, inside);
  if (!file) return finish(404, 'There is no such file.\n');
  const extension = extname(file);
  const twin = kEncodings.find(([encoding, suffix]) => accepts(request, encoding) && fileStat(`${file}.${suffix}`));
  const sent = twin ? `${file}.${twin[1]}` : file;
  const stat = fileStat(sent);
  const etag = `"${stat.size.toString(16)}-${Math.round(stat.mtimeMs).toString(16)}${twin ? twin[1] : ''}"`;
  const headers = {
    'Content-Type': kTypes[extension] ?? 'application/octet-stream',
    'Cache-Control': kHashed.test(file) ? 'public, max-age=31536000, immutable' : 'no-cache',
    ETag: etag,
    Vary: 'Accept-Encoding',
  };
  if (request.headers['if-none-match'] === etag) {
    response.writeHead(304, headers);
    return response.end();
  }
  headers['Content-Length'] = stat.size;
  if (twin) headers['Content-Encoding'] = twin[0];
  response.writeHead(200, headers);
  if (request.method === 'HEAD') return response.end();
  const stream = createReadStream(sent);
  stream.on('error', () => response.destroy());
  stream.pipe(response);
}

function listen(server, port, host) {
  return new Promise((resolve, reject) => {
    server.once('error', reject);
    server.listen(port, host, () => {
      server.off('error', reject);
      resolve(server.address().port);
    });
  });
}

/**
 * Serves `folder` and resolves to `{url, port, close()}`. With `port` 0 any free port is used, otherwise the first
 * free one from `port` on. `isolated` sends the two headers that make threads possible; `basePath` ("/" or "/a/b/")
 * is where the site hangs; `bare` leaves the content security policy to the page, as plain hosts do. `later`, a map from
 * paths to promises of paths (null: it failed), names files that are still being made: who asks for one waits and is sent
 * on to where it is then. `share`: a share server (web/share) that answers below `share/`, with the `addresses` of this
 * machine that others reach. `tls`: key and certificate, for https.
 */
export async function serveFolder(folder, options = {}) {
  const { port = 0, host = 'localhost', isolated = true, basePath = '/', later, bare = false, share, tls } = options;
  const base = normalize(folder);
  const policy = bare ? null : policyOf(base);
  const handle = (request, response) =>
    answer(request, response, { folder: base, basePath, isolated, later, policy, share });
  const times = share?.times ?? {};
  const server = tls ? createTlsServer({ ...times, ...tls }, handle) : createServer(times, handle);
  const tries = port === 0 ? [0] : Array.from({ length: 20 }, (_, index) => port + index);
  for (const candidate of tries) {
    try {
      const used = await listen(server, candidate, host);
      const close = () =>
        new Promise((resolve) => {
          server.close(resolve);
          // What the share server was sent before is answered.
          if (share) setTimeout(() => server.closeAllConnections(), kAnswerMs).unref();
          else server.closeAllConnections();
          server.closeIdleConnections();
        });
      return { url: `${tls ? 'https' : 'http'}://localhost:${used}${basePath}`, port: used, close };
    } catch (error) {
      if (error.code !== 'EADDRINUSE' && error.code !== 'EACCES') throw error;
    }
  }
  throw new Stop(`No free port was found from ${port} to ${tries[tries.length - 1]}.`);
}

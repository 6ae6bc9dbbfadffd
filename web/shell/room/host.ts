// Whether this host has a share server: share.json beside the page names it. A static host sends the file as it was built,
// which names none.
import { Failure } from '../failure.ts';

export interface HostInfo {
  /** Address of the server, ending with 'v1/'; null: there is none. */
  server: string | null;
  /** Addresses of this page that other devices in the network reach. */
  addresses: string[];
}

type ServerSide = typeof import('./server_side.ts');

const kNone: HostInfo = { server: null, addresses: [] };
let asked: Promise<HostInfo> | null = null;

async function ask(): Promise<HostInfo> {
  try {
    const told = (await (await fetch(new URL('share.json', document.baseURI))).json()) as Partial<HostInfo>;
    if (typeof told.server !== 'string') return kNone;
    const server = new URL(told.server, document.baseURI);
    // The policy of the page forbids any other place.
    if (server.origin !== location.origin) return kNone;
    const addresses = Array.isArray(told.addresses) ? told.addresses.filter((one) => typeof one === 'string') : [];
    return { server: server.href, addresses };
  } catch {
    return kNone;
  }
}

/** Asked once a visit. */
export const hostInfo = (): Promise<HostInfo> => (asked ??= ask());

let loaded: Promise<ServerSide> | null = null;

/** What is needed to talk to the server. */
export function serverSide(): Promise<ServerSide> {
  return (loaded ??= (import(new URL(SPINELOFT_SITE.serverSide, document.baseURI).href) as Promise<ServerSide>).catch(
    (thrown: unknown) => {
      loaded = null;
      throw thrown;
    },
  ));
}

/** The server of this host. Rejects with a Failure where it has none. */
export async function connected(): Promise<{ server: InstanceType<ServerSide['ShareServer']> }> {
  const { server } = await hostInfo();
  if (!server)
    throw new Failure('NoServer', 'There is no server here that keeps models. Share the long link or a file.');
  const { ShareServer } = await serverSide();
  return { server: new ShareServer(server) };
}

/** The address of this page that others can reach: on this machine's own name it is that of its network. */
export async function reachableAddress(): Promise<string> {
  const here = location.origin + location.pathname;
  const isOwn = ['localhost', '127.0.0.1', '[::1]'].includes(location.hostname);
  return isOwn ? ((await hostInfo()).addresses[0] ?? here) : here;
}

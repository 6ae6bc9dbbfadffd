// Pictures that the tests draw themselves, and files that are no good pictures.
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { deflateSync } from 'node:zlib';
import { PNG } from 'pngjs';
import { dataFolder, root } from '../../../.ci/lib/paths.mjs';

/** PNG bytes of a picture whose pixel (x, y) is paint(x, y) → [r, g, b, a?]. */
export function paintedPng(width, height, paint) {
  const png = new PNG({ width, height });
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const [r, g, b, a = 255] = paint(x, y);
      png.data.set([r, g, b, a], 4 * (y * width + x));
    }
  }
  return PNG.sync.write(png);
}

/**
 * A bent tube of the given half width on a light ground: its picture, its middle line and size.
 * Colours vary along the tube, so that a textured part differs from a plain one.
 */
export function tubePicture({ width = 480, height = 360, half = 28, transparent = false } = {}) {
  const middle = Array.from({ length: 61 }, (_, i) => {
    const t = i / 60;
    return [width * (0.15 + 0.7 * t), height * (0.55 - 0.22 * Math.sin(Math.PI * t))];
  });
  const distance = (x, y) => {
    let best = Infinity,
      at = 0;
    for (let i = 1; i < middle.length; ++i) {
      const [ax, ay] = middle[i - 1],
        [bx, by] = middle[i];
      const dx = bx - ax,
        dy = by - ay;
      const t = Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)));
      const d = Math.hypot(x - ax - t * dx, y - ay - t * dy);
      if (d < best) [best, at] = [d, i];
    }
    return { best, at };
  };
  const png = paintedPng(width, height, (x, y) => {
    const { best, at } = distance(x, y);
    if (best > half) return transparent ? [0, 0, 0, 0] : [236, 234, 228];
    return Math.floor(at / 10) % 2 ? [40, 70, 130] : [60, 110, 90];
  });
  return { png, middle: middle.slice(3, -3), width, height, half };
}

/** The same tube on a picture `times` as large, every pixel a square of its colour. */
export function enlarged(tube, times) {
  const small = PNG.sync.read(tube.png);
  const png = paintedPng(tube.width * times, tube.height * times, (x, y) => {
    const at = 4 * (Math.floor(y / times) * small.width + Math.floor(x / times));
    return small.data.subarray(at, at + 4);
  });
  const middle = tube.middle.map((point) => point.map((value) => (value + 0.5) * times - 0.5));
  return { png, middle, width: tube.width * times, height: tube.height * times, half: tube.half * times };
}

function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  const out = Buffer.alloc(body.length + 8);
  out.writeUInt32BE(data.length, 0);
  body.copy(out, 4);
  out.writeUInt32BE(crc32(body), body.length + 4);
  return out;
}

function crc32(bytes) {
  let value = 0xffffffff;
  for (const byte of bytes) {
    value ^= byte;
    for (let bit = 0; bit < 8; ++bit) value = (value >>> 1) ^ (value & 1 ? 0xedb88320 : 0);
  }
  return (value ^ 0xffffffff) >>> 0;
}

/** A grey PNG of any declared size; `rows` of it are really there (all by default). */
export function greyPng(width, height, rows = height) {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 0, 0, 0, 0], 8);
  const data = deflateSync(Buffer.alloc((width + 1) * rows, 0));
  return Buffer.concat([
    Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'),
    chunk('IHDR', header),
    chunk('IDAT', data),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

/** A JPEG with an EXIF block, a TIFF file of its own, put in after its start marker. */
function withExif(jpeg, tiff) {
  const body = Buffer.concat([Buffer.from('Exif\0\0', 'latin1'), tiff]);
  const segment = Buffer.concat([Buffer.from([0xff, 0xe1, 0, 0]), body]);
  segment.writeUInt16BE(body.length + 2, 2);
  return Buffer.concat([jpeg.subarray(0, 2), segment, jpeg.subarray(2)]);
}

export function withExifOrientation(jpeg, orientation) {
  return withExif(
    jpeg,
    Buffer.from([0x4d, 0x4d, 0, 42, 0, 0, 0, 8, 0, 1, 0x01, 0x12, 0, 3, 0, 0, 0, 1, 0, orientation, 0, 0, 0, 0, 0, 0]),
  );
}

/** Degrees, minutes and seconds as EXIF has them: three fractions. */
function fractions(values) {
  const bytes = Buffer.alloc(24);
  values.forEach(([over, under], i) => {
    bytes.writeUInt32BE(over, 8 * i);
    bytes.writeUInt32BE(under, 8 * i + 4);
  });
  return bytes;
}

/**
 * A JPEG as a telephone writes it, with where it was taken: an EXIF block whose first directory names the maker and
 * leads to a GPS directory. `places` is what of it must never be found anywhere else.
 */
export function withGps(jpeg) {
  const maker = Buffer.from('Telephone GPS Test\0\0', 'latin1'),
    latitude = fractions([
      [52, 1],
      [30, 1],
      [587654321, 10000019],
    ]),
    longitude = fractions([
      [13, 1],
      [22, 1],
      [398765413, 10000079],
    ]);
  const entry = (tag, type, count, value) => {
    const bytes = Buffer.alloc(12);
    bytes.writeUInt16BE(tag, 0);
    bytes.writeUInt16BE(type, 2);
    bytes.writeUInt32BE(count, 4);
    if (typeof value === 'number') bytes.writeUInt32BE(value, 8);
    else bytes.write(value, 8, 'latin1');
    return bytes;
  };
  const directory = (entries) => Buffer.concat([Buffer.from([0, entries.length]), ...entries, Buffer.alloc(4)]);
  const gpsAt = 8 + 2 + 2 * 12 + 4,
    makerAt = gpsAt + 2 + 4 * 12 + 4,
    latitudeAt = makerAt + maker.length,
    longitudeAt = latitudeAt + 24;
  const tiff = Buffer.concat([
    Buffer.from([0x4d, 0x4d, 0, 42, 0, 0, 0, 8]),
    directory([entry(0x010f, 2, maker.length, makerAt), entry(0x8825, 4, 1, gpsAt)]),
    directory([entry(1, 2, 2, 'N\0'), entry(2, 5, 3, latitudeAt), entry(3, 2, 2, 'E\0'), entry(4, 5, 3, longitudeAt)]),
    maker,
    latitude,
    longitude,
  ]);
  const places = {
    'the EXIF block': Buffer.from('Exif\0\0', 'latin1'),
    'its maker': maker.subarray(0, 18),
    'the latitude': latitude.subarray(16),
    'the longitude': longitude.subarray(16),
    'the latitude as a whole': latitude,
  };
  return { jpeg: withExif(jpeg, tiff), places };
}

/** The six samples of the start page, each with its file's bytes. */
export function samples() {
  const folder = join(root, 'assets/samples');
  const list = JSON.parse(readFileSync(join(folder, 'samples.json'), 'utf8'));
  return list.map((sample) => ({ ...sample, bytes: readFileSync(join(folder, sample.file)) }));
}

/** A few cases of the data folder, where there is one: picture and careful stroke. */
export function dataCases(names) {
  return names
    .filter((name) => dataFolder && existsSync(join(dataFolder, name, 'case.json')))
    .map((name) => {
      const about = JSON.parse(readFileSync(join(dataFolder, name, 'case.json'), 'utf8'));
      return {
        name,
        bytes: readFileSync(join(dataFolder, name, about.image)),
        width: about.width,
        height: about.height,
        spine: about.spines.careful,
      };
    });
}

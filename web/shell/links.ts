// The addresses that a model travels in. What stands behind the '#' is sent to no server.

/** In front of a share text in the address of the viewer, and of the page, which sends its visitors on to the viewer. */
export const kLinkMark = '#m=';
/** In front of a share text in the address of the page: it is opened for editing, as a new model. */
const kOwnMark = '#mine=';

const place = (file: string, hash: string) => new URL(file + hash, document.baseURI).href;

/** Where whoever has the link sees the model. */
export const viewAddress = (text: string): string => place('view.html', kLinkMark + text);

/** Where the model of this text is opened for editing. */
export const ownAddress = (text: string): string => place('./', kOwnMark + text);

/** The address of the viewer for a link that came to the page; null for any other address. */
export function viewerFor({ hash }: { hash: string }): string | null {
  return hash.startsWith(kLinkMark) ? place('view.html', hash) : null;
}

/** The text to be edited of the page's address, which is taken out of it: loading the page again must not open it again. */
export function takeOwn(): string | null {
  if (!location.hash.startsWith(kOwnMark)) return null;
  const text = location.hash.slice(kOwnMark.length);
  history.replaceState(null, '', location.pathname + location.search);
  return text;
}

/** What the address of a viewer asks for. */
export interface Wanted {
  /** A share text. */
  text: string | null;
  /** Address of a GLB, relative to the viewer. */
  glb: string | null;
  /** A picture to show before the model: a data address of a PNG, JPEG or WebP picture. */
  poster: string | null;
}

/** Of what stands behind the viewer's '#': fields 'm=TEXT', 'glb=PATH', 'poster=PICTURE' with '&' between them. */
export function wantedOf(hash: string): Wanted {
  const fields = new Map<string, string>();
  for (const field of hash.replace(/^#/, '').split('&')) {
    const [, name, value] = /^(m|glb|poster)=(.+)$/.exec(field) ?? [];
    if (name && value && !fields.has(name)) fields.set(name, value);
  }
  const poster = fields.get('poster') ?? '';
  return {
    text: fields.get('m') ?? null,
    glb: fields.get('glb') ?? null,
    poster: /^data:image\/(png|jpeg|webp);base64,[\w+/=]+$/.test(poster) ? poster : null,
  };
}

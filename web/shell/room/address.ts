// Links that need the server: a stored model and a class. What stands behind '#' is sent to no server: id and key.

export interface ServerLink {
  /** 'stored': a model to look at; 'own': the same, to be opened for editing; 'wall': a screen that shows the class without taking part. */
  kind: 'stored' | 'own' | 'class' | 'wall';
  id: string;
  key: string;
}

const kMark = /^#(stored|own|class|wall)=([A-Za-z0-9_-]{22})\.([A-Za-z0-9_-]{43})$/;

export function readServerLink(hash: string): ServerLink | null {
  const [, kind, id, key] = kMark.exec(hash) ?? [];
  return id && key ? { kind: kind as ServerLink['kind'], id, key } : null;
}

/** The stored model that a link or its text names; null where it is another link. */
export function serverLinkIn(text: string): ServerLink | null {
  const at = text.indexOf('#');
  const link = readServerLink(at < 0 ? `#stored=${text}` : text.slice(at));
  return link?.kind === 'stored' || link?.kind === 'own' ? link : null;
}

/** The one in the page's address, which is taken out of it. */
export function takeServerLink(): ServerLink | null {
  const link = readServerLink(location.hash);
  if (link) history.replaceState(null, '', location.pathname + location.search);
  return link;
}

export const serverLink = (base: string, { kind, id, key }: ServerLink): string => `${base}#${kind}=${id}.${key}`;

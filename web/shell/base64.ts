// Bytes as letters, digits, '-' and '_' (RFC 4648, section 5, without padding).

/** Pieces that String.fromCharCode takes at once. */
const kPiece = 8192;

export function base64url(bytes: Uint8Array): string {
  let binary = '';
  for (let at = 0; at < bytes.length; at += kPiece) binary += String.fromCharCode(...bytes.subarray(at, at + kPiece));
  return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** Throws where the text is none. */
export function fromBase64url(text: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
}

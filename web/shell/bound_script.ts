// Workers under the page's content security policy. A worker from a file is under the policy of that file's headers,
// which plain hosts do not send; a worker from a blob is under the policy of the page that made the blob.

const addresses = new Map<string, string>();

/** Address of a worker's script, as a module, that imports the one at `path` of the site. It holds as long as the page. */
export function boundScript(path: string): string {
  let address = addresses.get(path);
  if (address === undefined) {
    const script = `import ${JSON.stringify(new URL(path, document.baseURI).href)};`;
    address = URL.createObjectURL(new Blob([script], { type: 'text/javascript' }));
    addresses.set(path, address);
  }
  return address;
}

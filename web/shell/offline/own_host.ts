// A service worker cannot be started from a blob, so it is under the policy of its file's headers, which plain hosts do
// not send. It is kept to its own host here, before anything else of it runs.

const ask = globalThis.fetch.bind(globalThis);

globalThis.fetch = (request, options) => {
  const address = request instanceof Request ? request.url : new URL(request, location.href).href;
  if (new URL(address).origin !== location.origin)
    return Promise.reject(new TypeError(`The page asks no other host, as for ${address}.`));
  return ask(request, options);
};

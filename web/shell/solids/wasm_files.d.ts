/** A file of WebAssembly is imported as its hashed address, relative to the importing script. */
declare module '*.wasm' {
  const url: string;
  export default url;
}

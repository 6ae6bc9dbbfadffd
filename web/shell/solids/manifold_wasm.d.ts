declare module 'manifold-3d/manifold.wasm' {
  const url: string;
  export default url;
}

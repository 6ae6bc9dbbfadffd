// A canvas as a small file.

/** As WebP, or where the browser does not write it as JPEG on white. */
export async function canvasFile(canvas: HTMLCanvasElement, quality: number): Promise<Uint8Array> {
  const write = (type: string) => new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, type, quality));
  let blob = await write('image/webp');
  if (blob?.type !== 'image/webp') {
    const context = canvas.getContext('2d')!;
    context.globalCompositeOperation = 'destination-over';
    context.fillStyle = '#fff';
    context.fillRect(0, 0, canvas.width, canvas.height);
    blob = await write('image/jpeg');
  }
  return new Uint8Array(await blob!.arrayBuffer());
}

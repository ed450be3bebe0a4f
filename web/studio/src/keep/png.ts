// Pictures of points: a drawing of the core as PNG.
const SHARP = 2; // px of a PNG for each px of the drawing

// Loads an SVG document as an image.
async function imageOf(svg: string): Promise<HTMLImageElement> {
  const address = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" })), image = new Image();
  try {
    image.src = address;
    await image.decode();
    return image;
  } finally {
    URL.revokeObjectURL(address);
  }
}

function sheet(width: number, height: number): [HTMLCanvasElement, CanvasRenderingContext2D] {
  const paper = document.createElement("canvas"), context = paper.getContext("2d")!;
  [paper.width, paper.height] = [Math.round(width), Math.round(height)];
  return [paper, context];
}

function paint(context: CanvasRenderingContext2D, image: HTMLImageElement, scale: number): void {
  context.fillStyle = "#fcfcfa"; // the paper of the core's drawings
  context.fillRect(0, 0, context.canvas.width, context.canvas.height);
  context.drawImage(image, 0, 0, image.width * scale, image.height * scale);
}

// Returns an SVG drawing as PNG.
export async function pngOf(svg: string): Promise<Uint8Array<ArrayBuffer>> {
  const image = await imageOf(svg), [paper, context] = sheet(SHARP * image.width, SHARP * image.height);
  paint(context, image, SHARP);
  const blob = await new Promise<Blob | null>((done) => paper.toBlob(done, "image/png"));
  if (!blob) throw new Error("the browser made no PNG");
  return new Uint8Array(await blob.arrayBuffer());
}

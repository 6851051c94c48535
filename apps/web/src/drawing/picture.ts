/** What a picture is painted with. */
export type PictureContext = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D

let easel: OffscreenCanvas | null = null

/**
 * Paints a picture that is shown again and again. As a bitmap, where the browser has them apart from the page: of a canvas
 * it would look at each showing whether it has changed.
 * @param width of the picture in whole px, as is its `height`
 */
export function pictureOf(
  width: number,
  height: number,
  draw: (context: PictureContext) => void,
): ImageBitmap | HTMLCanvasElement {
  if (typeof OffscreenCanvas === 'undefined') {
    const canvas = Object.assign(document.createElement('canvas'), { width, height })
    draw(canvas.getContext('2d')!)
    return canvas
  }
  easel ??= new OffscreenCanvas(width, height)
  Object.assign(easel, { width, height })
  draw(easel.getContext('2d')!)
  return easel.transferToImageBitmap()
}

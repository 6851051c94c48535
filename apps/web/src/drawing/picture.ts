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
  const own = easel ?? new OffscreenCanvas(width, height)
  // A picture may need another one, such as a pattern, while it is painted: that one takes another canvas.
  easel = null
  Object.assign(own, { width, height })
  draw(own.getContext('2d')!)
  easel = own
  return own.transferToImageBitmap()
}

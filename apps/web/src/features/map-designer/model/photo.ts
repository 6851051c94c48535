import { toBase64 } from '@botgarten/browsers'
import { mostOfMap, paper } from '@botgarten/programs'
import { readPictureHead } from '#parts/picture-file.ts'

/** A photo as a map holds it (base64), or why it is not taken: the word `design.photoProblem.<problem>`. */
export type PhotoRead = { readonly photo: string } | { readonly problem: PhotoProblem }
type PhotoProblem = 'kind' | 'svg' | 'broken' | 'heavy' | 'wide'

const MOST_BYTES = 20_000_000
/** Dots on a side beyond which a picture is not even unpacked. */
const MOST_DOTS = 10_000
/** Widths in dots and qualities of a JPEG, tried until it is small enough. */
const tries = [
  { width: 1600, quality: 0.8 },
  { width: 1600, quality: 0.6 },
  { width: 1200, quality: 0.6 },
  { width: 800, quality: 0.5 },
] as const

/** A picture file as a new JPEG that fills the paper: what the camera noted in it (EXIF) is gone. */
export async function photoFrom(file: File): Promise<PhotoRead> {
  if (file.size > MOST_BYTES) return { problem: 'heavy' }
  const head = readPictureHead(new Uint8Array(await file.arrayBuffer()))
  if (typeof head === 'string') return { problem: head }
  if (Math.max(head.width, head.height) > MOST_DOTS) return { problem: 'wide' }
  const bitmap = await createImageBitmap(file).catch(() => null)
  if (!bitmap) return { problem: 'broken' }
  const photo = await asJpeg(bitmap, bitmap, Math.max)
  bitmap.close()
  return photo
}

/** A cleaned drawing as a photo of the whole of it, on the paper as its stations are (see `openMap`). */
export async function photoOfDrawing(svg: string): Promise<PhotoRead> {
  const image = new Image()
  image.src = `data:image/svg+xml,${encodeURIComponent(svg)}`
  try {
    await image.decode()
  } catch {
    return { problem: 'broken' }
  }
  return asJpeg(image, { width: image.naturalWidth, height: image.naturalHeight }, Math.min)
}

/** @param fit of both scales the one that fills the paper, or the one that shows all */
async function asJpeg(
  picture: CanvasImageSource,
  size: { readonly width: number; readonly height: number },
  fit: (...scales: number[]) => number,
): Promise<PhotoRead> {
  for (const { width, quality } of tries) {
    const canvas = document.createElement('canvas')
    canvas.width = width
    canvas.height = (width * paper.height) / paper.width
    const pen = canvas.getContext('2d')!
    pen.fillStyle = '#FFFDF8'
    pen.fillRect(0, 0, canvas.width, canvas.height)
    pen.imageSmoothingQuality = 'high'
    const scale = fit(canvas.width / size.width, canvas.height / size.height)
    const [wide, high] = [size.width * scale, size.height * scale]
    pen.drawImage(picture, (canvas.width - wide) / 2, (canvas.height - high) / 2, wide, high)
    const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/jpeg', quality))
    const photo = blob?.type === 'image/jpeg' ? toBase64(new Uint8Array(await blob.arrayBuffer())) : ''
    if (photo !== '' && photo.length <= mostOfMap.photo) return { photo }
  }
  return { problem: 'heavy' }
}

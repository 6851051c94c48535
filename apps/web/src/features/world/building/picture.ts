import { toBase64 } from '@botgarten/browsers'
import { sha256, writeProject, type Project } from '@botgarten/programs'
import type { Picture } from '@botgarten/simulation'
import { readPng } from '@botgarten/simulation/png'
import { readPictureHead } from '#parts/picture-file.ts'

/** A picture for the floor, as it is kept. */
export interface FloorPicture {
  readonly asset: string
  readonly assets: Project['assets']
  readonly picture: Picture
}

/** Why a picture is not taken: the words `problem.<problem>.title` and `.text` with these facts. */
export interface PictureRefusal {
  readonly problem: string
  readonly facts: { readonly [name: string]: number }
}

const MOST_BYTES = 20_000_000
/** Dots on a side beyond which a picture is not even unpacked. */
const MOST_DOTS = 10_000
/** Sizes that are tried until it fits into the project. */
const BOXES = [
  { width: 1600, height: 1200 },
  { width: 1000, height: 750 },
  { width: 600, height: 450 },
]
const MOST_PROJECT = 5_000_000

const refused = (problem: string, facts: PictureRefusal['facts'] = {}): PictureRefusal => ({ problem, facts })

/** Turns a picture file, once, into a PNG that the floor is made from (running.md 6). */
export async function floorPictureFrom(file: File, project: Project): Promise<FloorPicture | PictureRefusal> {
  if (file.size > MOST_BYTES) return refused('pictureTooHeavy')
  const head = readPictureHead(new Uint8Array(await file.arrayBuffer()))
  if (head === 'svg') return refused('pictureSvg')
  if (head === 'kind') return refused('pictureKind')
  if (head === 'broken') return refused('pictureBroken')
  if (Math.max(head.width, head.height) > MOST_DOTS)
    return refused('pictureTooWide', { width: head.width, height: head.height, most: MOST_DOTS })
  const bitmap = await createImageBitmap(file).catch(() => null)
  if (!bitmap) return refused('pictureBroken')
  try {
    return await smallEnough(bitmap, project)
  } finally {
    bitmap.close()
  }
}

async function smallEnough(bitmap: ImageBitmap, project: Project): Promise<FloorPicture | PictureRefusal> {
  const rest = writeProject({ ...project, assets: {} }).length + 1000
  for (const box of BOXES) {
    const png = await redrawn(bitmap, box)
    const base64 = toBase64(png)
    if (base64.length + rest > MOST_PROJECT) continue
    const asset = sha256(png)
    return { asset, assets: { [asset]: { type: 'image/png', base64 } }, picture: readPng(png) }
  }
  return refused('pictureNoRoom')
}

async function redrawn(bitmap: ImageBitmap, box: (typeof BOXES)[number]): Promise<Uint8Array> {
  const shrink = Math.min(1, box.width / bitmap.width, box.height / bitmap.height)
  const canvas = document.createElement('canvas')
  canvas.width = Math.max(1, Math.floor(bitmap.width * shrink))
  canvas.height = Math.max(1, Math.floor(bitmap.height * shrink))
  const pen = canvas.getContext('2d')!
  // What lets light through lies on white paper.
  pen.fillStyle = '#FFFFFF'
  pen.fillRect(0, 0, canvas.width, canvas.height)
  pen.imageSmoothingQuality = 'high'
  pen.drawImage(bitmap, 0, 0, canvas.width, canvas.height)
  const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/png'))
  return new Uint8Array(await blob!.arrayBuffer())
}

import { createRequire } from 'node:module'
import type { Locator } from '@playwright/test'

// It is not a module of today: what it exports is beside, not in, what `import` would give.
const jsQR = (createRequire(import.meta.url)('jsqr') as typeof import('jsqr')).default

/** What a camera reads in a code as it stands on the screen; null: it cannot. */
export async function reads(code: Locator): Promise<string | null> {
  const png = (await code.screenshot()).toString('base64')
  const { grey, width } = await code.page().evaluate(async (text) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))
    const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }))
    const paper = new OffscreenCanvas(image.width, image.height).getContext('2d')!
    paper.drawImage(image, 0, 0)
    const { data } = paper.getImageData(0, 0, image.width, image.height)
    return { grey: Array.from(data).filter((_, at) => at % 4 === 1), width: image.width }
  }, png)
  const pixels = Uint8ClampedArray.from(grey.flatMap((one) => [one, one, one, 255]))
  return jsQR(pixels, width, grey.length / width)?.data ?? null
}

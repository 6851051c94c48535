import { gallery } from '#features/gallery/feature.ts'
import { fetchWords } from '#words/message.ts'
import type { PageLoad } from './$types'

export const load: PageLoad = async () => {
  const [{ GalleryPage }] = await Promise.all([gallery.load(), fetchWords(...gallery.words)])
  return { GalleryPage }
}

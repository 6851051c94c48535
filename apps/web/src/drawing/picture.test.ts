import { afterEach, expect, test, vi } from 'vitest'
import { pictureOf, type PictureContext } from './picture.ts'

/** A canvas that holds the words written on it; as in a browser, a new size empties it. */
class FakeCanvas {
  words: string[] = []
  set width(_: number) {
    this.words = []
  }
  getContext = () => ({ fillText: (word: string) => this.words.push(word) })
  transferToImageBitmap = () => this.words.splice(0)
}
const write = (word: string) => (context: PictureContext) => context.fillText(word, 0, 0)

afterEach(() => vi.unstubAllGlobals())

test('a picture keeps what is on it while another one is painted for it', () => {
  vi.stubGlobal('OffscreenCanvas', FakeCanvas)
  const picture = pictureOf(9, 9, (context) => {
    write('links')(context)
    expect(pictureOf(3, 3, write('stripes'))).toEqual(['stripes'])
    write('more links')(context)
  })
  expect(picture).toEqual(['links', 'more links'])
  expect(pictureOf(9, 9, write('next'))).toEqual(['next'])
})

import { content } from '@botgarten/content/files'
import { cardProject } from '@botgarten/content'
import { hasMessage } from '#words/message.ts'
import { expect, test } from 'vitest'
import { picture } from '../../../../../../e2e/png.ts'
import { floorPictureFrom } from './picture.ts'

const { card, world, start } = content.card('friendship')!
const project = cardProject(world, card, start, 'A floor')

/** A PNG that says it is so big, with all its pieces in place. */
function huge(width: number, height: number): Buffer {
  const png = picture(8, 8)
  png.writeUInt32BE(width, 16)
  png.writeUInt32BE(height, 20)
  return png
}

const svg = '<svg xmlns="http://www.w3.org/2000/svg"><script>document.title = "!"</script></svg>'

test.each([
  ['big.png', huge(20_000, 20_000), 'pictureTooWide', { width: 20_000, height: 20_000, most: 10_000 }],
  ['high.png', huge(10, 10_001), 'pictureTooWide', { width: 10, height: 10_001, most: 10_000 }],
  ['diary.png', Buffer.from('Dear diary, today Bo drove'), 'pictureKind', {}],
  ['cut.png', picture(50, 50).subarray(0, 60), 'pictureBroken', {}],
  ['map.svg', Buffer.from(svg), 'pictureSvg', {}],
  ['heavy.png', Buffer.alloc(20_000_001), 'pictureTooHeavy', {}],
])('%s is no floor, and there are words for why', async (name, bytes, problem, facts) => {
  const file = new File([new Uint8Array(bytes)], name)
  expect(await floorPictureFrom(file, project)).toEqual({ problem, facts })
  for (const part of ['title', 'text']) expect(hasMessage(`problem.${problem}.${part}`)).toBe(true)
})

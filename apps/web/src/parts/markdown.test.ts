import { expect, test } from 'vitest'
import { readCardText } from '@botgarten/content'
import { spoken } from './markdown.ts'

const section =
  '## Goal\n**Go!** Now.\n## Checks\n- near: comes near\n## Hint 1\na\n## Hint 2\nb\n## Hint 3\nc\n## Further\nd'
const storyOf = (markdown: string) => readCardText(`# Title\n## Story\n${markdown}\n${section}`).story

test('a text is said without its signs, paragraphs with a pause between', () => {
  expect(spoken(storyOf('Bo sees a **blue** square\n\nWhat _now_?'))).toBe('Bo sees a blue square. What now?')
})

test('each line of a list is a sentence', () => {
  expect(spoken(storyOf('- one\n- **two** and three'))).toBe('one. two and three.')
})

import { completeLanguages, wordsOf } from '@botgarten/messages/folder'
import { expect, test } from 'vitest'
import { content } from '../files.ts'
import { nodesOf } from '../items/walk.ts'
import { plainOf } from '../schema/markdown.ts'

/** Items that tell step by step what to press: a renamed button must not leave them behind. */
const steps = [
  'worksheet/own-map-sheet',
  'worksheet/my-examples',
  'worksheet/what-i-expect',
  'worksheet/all-of-us',
]

test.each(steps.flatMap((item) => completeLanguages.map((language) => [item, language] as const)))(
  'what is bold in %s stands on the screen, in "%s"',
  (item, language) => {
    const labels = new Set(Object.values(wordsOf(language)))
    // What ends with a colon introduces its own line.
    const nodes = nodesOf(content.itemTexts(language).items[item]!, false)
    const bold = [...nodes].flatMap((node) => (node.type === 'strong' ? [plainOf(node)] : []))
    expect(bold.length).toBeGreaterThan(0)
    expect(bold.filter((words) => !/:$/.test(words) && !labels.has(words))).toEqual([])
  },
)

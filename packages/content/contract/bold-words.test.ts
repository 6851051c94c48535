import { wordsOf } from '@botgarten/messages/folder'
import { expect, test } from 'vitest'
import { content } from '../files.ts'
import type { ItemNode } from '../items/index.ts'
import { plainOf } from '../schema/markdown.ts'

/** Items that tell step by step what to press: a renamed button must not leave them behind. */
const steps = ['worksheet/own-map-sheet', 'curriculum/lesson-own-map', 'curriculum/lesson-zoo']

const boldIn = (nodes: readonly ItemNode[]): readonly string[] =>
  nodes.flatMap((node) => {
    if (node.type === 'strong') return [plainOf(node)]
    return 'children' in node ? boldIn(node.children) : []
  })

test.each(steps.flatMap((item) => content.languages.map((language) => [item, language] as const)))(
  'what is bold in %s stands on the screen, in "%s"',
  (item, language) => {
    const labels = new Set(Object.values(wordsOf(language)))
    const { lead, sections } = content.itemTexts(language).items[item]!
    // What ends with a colon introduces its own line.
    const bold = boldIn([...lead, ...sections.flatMap(({ body }) => body)]).filter(
      (words) => !/:$/.test(words),
    )
    expect(bold.length).toBeGreaterThan(0)
    expect(bold.filter((words) => !labels.has(words))).toEqual([])
  },
)

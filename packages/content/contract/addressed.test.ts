import { expect, test } from 'vitest'
import { content } from '../files.ts'
import { textOf } from './there.ts'

/** Letters to parents: a school writes to them as strangers. */
const letters = ['letter-to-parents', 'study-consent']

/** The polite address; at the beginning of a sentence it cannot be told from "they". */
const polite = /(?<=[\p{L}\d,;] )(?:Sie|Ihnen|Ihr(?:e[mnrs]?)?)\b.*/gu

test('teachers and children are spoken to alike in German: du, never Sie', () => {
  const found = content.items.flatMap(({ id }) =>
    (textOf(content.itemFolder(id), 'de.md').match(polite) ?? []).map((said) => [id, said] as const),
  )
  expect(found.filter(([id]) => !letters.includes(id))).toEqual([])
  // What is looked for is found where it belongs.
  expect([...new Set(found.map(([id]) => id))].toSorted()).toEqual(letters)
})

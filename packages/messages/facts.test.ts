import { expect, test } from 'vitest'
import { typesOf } from './facts.ts'

test('a message is a function of the facts that it says', () => {
  const count = { 'n=one': 'one by {name}', 'n=other': '{count} by {name}' }
  const table = {
    'app.hello': 'Hello',
    'app.both': '{b} and {a}, not \\{c\\}',
    'app.count': [
      {
        declarations: ['input name', 'input count', 'local n = count: plural'],
        selectors: ['n'],
        match: count,
      },
    ],
  } as const
  expect(typesOf(table)).toBe(`export interface Messages {
  readonly "app.hello": () => string
  readonly "app.both": (facts: { readonly a: string | number; readonly b: string | number }) => string
  readonly "app.count": (facts: { readonly count: string | number; readonly name: string | number }) => string
}
`)
})

test('a message with a single fact is a function of it', () => {
  expect(typesOf({ 'app.one': 'Only {name}' })).toBe(`export interface Messages {
  readonly "app.one": (facts: { readonly name: string | number }) => string
}
`)
})

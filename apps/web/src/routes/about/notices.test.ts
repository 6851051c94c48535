import { expect, test } from 'vitest'
import { fonts, libraries } from './notices.ts'

test('each font is named with whose it is', () => {
  expect(fonts.map((font) => font.replace(/ Copyright.*/, ''))).toEqual(
    expect.arrayContaining(['Baloo 2', 'Nunito']),
  )
  for (const font of fonts) expect(font).toMatch(/Copyright \d{4}(-\d{4})? .+ Authors/)
})

test('each library is named with whose it is and its licence', () => {
  expect(libraries.map(([name]) => name)).toEqual(
    expect.arrayContaining(['Blockly', 'Svelte', 'valibot', 'idb']),
  )
  for (const [name, whose, licence] of libraries) {
    expect(name).not.toBe('')
    expect(whose).toMatch(/^Copyright /)
    expect(licence).toMatch(/^(MIT|ISC|Apache License)/)
  }
})

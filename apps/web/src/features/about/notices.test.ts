import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { unlike } from '../../../notices.ts'
import { fonts, libraries, licenceTexts } from './notices.ts'

test('each font is named with whose it is', () => {
  expect(fonts.map((font) => font.replace(/ Copyright.*/, ''))).toEqual(
    expect.arrayContaining(['Baloo 2', 'Nunito']),
  )
  for (const font of fonts) expect(font).toMatch(/Copyright \d{4}(-\d{4})? .+ Authors/)
})

test('each library is named with whose it is and its licence', () => {
  expect(libraries.map(([name]) => name)).toEqual(
    expect.arrayContaining(['Blockly', 'Svelte', 'valibot', 'idb', 'sax', 'lean-qr']),
  )
  for (const [name, whose, licence] of libraries) {
    expect(name).not.toBe('')
    expect(whose).toMatch(/^Copyright /)
    expect(licence).toMatch(/^(MIT|ISC|Apache License|Blue Oak Model License)/)
  }
})

const table = `Libraries

Svelte           Copyright Svelte        MIT  svelte, esm-env
SvelteKit        Copyright Kit           MIT  @sveltejs/kit
micromark, more  Copyright Titus Wormer  MIT  micromark*

MIT`

test('the build ends where a library is served without its notice, and where a notice is of nothing served', () => {
  const at = (path: string) => `/home/lab/node_modules/${path}`
  const served = [at('svelte/src/index.js'), at('@sveltejs/kit/src/a.js'), at('micromark-util-x/index.js')]
  expect(unlike([...served, '/home/lab/apps/web/src/a.ts'], table)).toEqual({
    unlisted: [],
    unused: ['esm-env'],
  })
  expect(
    unlike(
      [at('esm-env/a.js'), at('other/node_modules/lean-qr/b.js'), 'C:\\x\\node_modules\\@a\\b\\c.js'],
      table,
    ),
  ).toEqual({
    unlisted: ['@a/b', 'lean-qr'],
    unused: ['svelte', '@sveltejs/kit', 'micromark*'],
  })
})

test('the complete text of every licence is served', () => {
  const texts = licenceTexts.map(([, file]) =>
    readFileSync(new URL(`../../../static/${file}`, import.meta.url), 'utf8'),
  )
  const heads = [/Apache License/, /Open Font License/i, /Open Font License/i, /Open Font License/i, /MIT/]
  for (const [at, head] of heads.entries()) expect(texts[at]).toMatch(head)
  // Fonts and licences are named before their texts.
  const names = licenceTexts.map(([name]) => name)
  expect(names.slice(1, 4).map((name) => name.split(':')[0])).toEqual(
    expect.arrayContaining(fonts.map((font) => font.replace(/ Copyright.*/, ''))),
  )
  const licences = new Set(libraries.map(([, , licence]) => licence.split(/[ ,]/)[0]!))
  for (const licence of licences) expect(names.some((name) => name.includes(licence))).toBe(true)
})

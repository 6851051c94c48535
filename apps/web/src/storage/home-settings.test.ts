import { cardConfig, defaultConfig } from '@botgarten/simulation'
import fc from 'fast-check'
import { globSync, readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import {
  mergeSettings,
  readSettings,
  settingNames,
  settingsIn,
  type Drawer,
  type HomeSettings,
} from './home-settings.ts'

const drawerWith = (texts: { readonly [name: string]: string }) => {
  const lies = new Map(Object.entries(texts))
  const drawer: Drawer = { get: (name) => lies.get(name) ?? null, put: (name, text) => lies.set(name, text) }
  return { drawer, texts: () => Object.fromEntries(lies) }
}
const all: HomeSettings = {
  comfort: { projector: false, quiet: true, letters: true, aloud: false },
  dialect: 'ev3dev2',
  'code-gaps': false,
  'code-learner': true,
  language: 'de',
  'my-set': {
    ...{ name: 'Tuesday', children: 24, paper: 'a4', grey: false, sets: 3, languages: ['de', 'en'] },
    lines: [
      { of: 'item:my-knobs', for: 'pair' },
      { of: 'card:fear', for: 4, times: 6 },
    ],
  },
  'network-level': 'explorer',
  'network-tens': true,
  'q-level': 'expert',
  robots: { 'Wall-E': cardConfig },
  settings: { rays: false, trail: true },
  sizes: { columns: [0.3, 0.4], rows: [0.5, 0.6] },
  sorting: { source: 'points', rows: [[1, 2]] },
  sound: false,
  tour: 'seen',
  zoo: { fountain: { guess: 'never', mended: true } },
  'zoo-senses': { spinner: { guess: 'honest', watched: true, mended: false } },
}

/** `sorting` was written until November 2026, and becomes a project. */
test('every setting that any page writes goes home', () => {
  const source = new URL('..', import.meta.url)
  const written = globSync('**/*.{ts,svelte}', { cwd: source }).flatMap((file) =>
    [...readFileSync(new URL(file, source), 'utf8').matchAll(/writeSetting\('([^']+)'/g)].map(
      ([, name]) => name,
    ),
  )
  expect(new Set(settingNames)).toEqual(new Set([...written, 'language', 'sorting']))
})

test('on a device where nothing is set, everything is set as it was', () => {
  const here = drawerWith({})
  expect(mergeSettings(here.drawer, all)).toEqual({ taken: settingNames, kept: [] })
  expect(settingsIn(here.drawer)).toEqual(all)
  // Words are kept as the pages read them.
  expect(here.texts()).toMatchObject({ language: 'de', tour: '"seen"', sound: 'false' })
  expect(mergeSettings(here.drawer, all)).toEqual({ taken: [], kept: [] })
})

test('what is set here stays, and is named where it differs', () => {
  const here = drawerWith({ language: 'en', sound: 'false' })
  const { taken, kept } = mergeSettings(here.drawer, all)
  expect(kept).toEqual(['language'])
  expect(taken).not.toContain('sound')
  expect(here.texts()['language']).toBe('en')
})

test.each([
  ['no object', 'all of them'],
  ['a list', [1, 2]],
  ['an unknown name', { password: 'x' }],
  ['a size beyond the screen', { sizes: { columns: [0.5, 7] } }],
  ['a size that is no number', { sizes: { columns: ['a', 'b'] } }],
  ['a language nobody speaks here', { language: 'xx' }],
  ['an option nobody knows', { comfort: { quiet: true, evil: true } }],
  ['a switch that is a word', { sound: 'on', settings: { rays: 'yes', trail: true } }],
  ['sorted things without end', { sorting: { rows: 'x'.repeat(1_000_001) } }],
  ['names of every object', { constructor: true, toString: 'x', hasOwnProperty: 1 }],
])('%s is no setting', (_, data) => {
  expect(readSettings(data)).toEqual({})
})

test('whatever stands there, only what is a setting is left, and a second look finds the same', () => {
  const some = fc.record(
    Object.fromEntries(settingNames.map((name) => [name, fc.oneof(fc.jsonValue(), fc.constant(all[name]))])),
    { requiredKeys: [] },
  )
  fc.assert(
    fc.property(fc.oneof(fc.jsonValue(), some), (anything) => {
      // As a file holds it: there −0 is 0.
      const data: unknown = JSON.parse(JSON.stringify(anything))
      const read = readSettings(data)
      expect(settingNames).toEqual(expect.arrayContaining(Object.keys(read)))
      expect(readSettings(JSON.parse(JSON.stringify(read)))).toEqual(read)
    }),
  )
})

test('a device whose own settings are broken takes none of them home', () => {
  const { drawer } = drawerWith({ comfort: '{', sizes: '{"columns":"x"}', sound: 'true' })
  expect(settingsIn(drawer)).toEqual({ sound: true })
})

test('robots of both are there after it, and this device’s where both have the name', () => {
  const here = drawerWith({ robots: JSON.stringify({ Bo: defaultConfig, Rex: cardConfig }) })
  const { taken, kept } = mergeSettings(here.drawer, { robots: { 'Wall-E': cardConfig, Bo: cardConfig } })
  expect([taken, kept]).toEqual([[], []])
  expect(settingsIn(here.drawer).robots).toEqual({ 'Wall-E': cardConfig, Bo: defaultConfig, Rex: cardConfig })
})

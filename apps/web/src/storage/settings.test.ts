import fc from 'fast-check'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { readSettings } from './home-settings.ts'
import { settings, readSetting, writeSetting } from './settings.ts'

const texts = new Map<string, string>()
const shelf = {
  getItem: (key: string) => texts.get(key) ?? null,
  setItem: (key: string, text: string) => void texts.set(key, text),
}
beforeEach(() => {
  texts.clear()
  vi.stubGlobal('localStorage', shelf)
})
afterEach(() => void vi.unstubAllGlobals())

const good: { readonly [name in keyof typeof settings]: unknown } = {
  comfort: { projector: false, quiet: true },
  'code-gaps': false,
  'code-learner': true,
  dialect: 'ev3dev2',
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
  robots: { Flitzer: { wheelDiameter: 5.6 } },
  settings: { rays: false, trail: true },
  sizes: { columns: [0.3, 0.4] },
  sorting: { rows: [[1, 2]] },
  sound: false,
  tour: 'seen',
  zoo: { fountain: { guess: 'never', mended: true } },
  'zoo-senses': { spinner: { guess: 'honest', watched: true, mended: false } },
}
const names = Object.keys(settings) as (keyof typeof settings)[]

test.each(names)('%s is read as it was written, and its preset where nothing was', (name) => {
  expect(readSetting(name, 'preset')).toBe('preset')
  writeSetting(name, good[name])
  expect(readSetting(name, 'preset')).toEqual(good[name])
})

test('whatever lies there, a page gets a setting or its preset', () => {
  const text = fc.oneof(
    fc.string(),
    fc.jsonValue().map((value) => JSON.stringify(value)),
  )
  fc.assert(
    fc.property(fc.constantFrom(...names), text, (name, lies) => {
      texts.set(`botgarten.${name}`, lies)
      const read: unknown = readSetting(name, 'preset')
      // The same table says what may go home.
      if (read !== 'preset') expect(readSettings({ [name]: read })).toHaveProperty(name)
    }),
    { numRuns: 1000 },
  )
})

test.each([
  ['settings', null],
  ['settings', {}],
  ['sizes', { columns: [9, 'x'] }],
  ['sizes', null],
  ['dialect', 'pascal'],
  ['my-set', { name: '', children: 24, paper: 'a4', grey: false, lines: [{ of: 'http://x', for: 'pair' }] }],
  ['network-level', 'wizard'],
  ['q-level', 7],
  ['network-tens', 'yes'],
  ['comfort', [1]],
])('a damaged setting %s is not used', (name, value) => {
  writeSetting(name, value)
  expect(readSetting(name, 'preset')).toBe('preset')
})

test('a name that is a word of every object is nothing special', () => {
  const name = 'constructor'
  writeSetting(name, 1)
  expect(readSetting(name, 0)).toBe(1)
})

test('a browser that refuses gives presets and takes nothing', () => {
  const refuse = () => {
    throw new DOMException('Refused for a test.', 'SecurityError')
  }
  vi.stubGlobal('localStorage', { getItem: refuse, setItem: refuse })
  writeSetting('sound', false)
  expect(readSetting('sound', true)).toBe(true)
})

const set = good['my-set'] as { readonly lines: readonly object[] }
const withLine = (line: object) => ({ ...set, lines: [line] })

test.each([
  ['sizes', { columns: [0, 1] }, { columns: [0, 1.01] }],
  ['sizes', { rows: [0.5, 0] }, { rows: [-0.01, 0.5] }],
  ['my-set', withLine({ of: 'card:fear', for: 'child' }), withLine({ of: 'card:fear', for: 'everybody' })],
  ['my-set', withLine({ of: 'card:fear', for: 2 }), withLine({ of: 'card:fear', for: 1 })],
  ['my-set', { ...set, children: 99 }, { ...set, children: 100 }],
  ['robots', { ['x'.repeat(100)]: 1 }, { ['x'.repeat(101)]: 1 }],
  [
    'zoo',
    { ['x'.repeat(60)]: { guess: 'wish', mended: false } },
    { ['x'.repeat(61)]: { guess: 'wish', mended: false } },
  ],
])('%s has its limits: %j is read, %j is not', (name, most, more) => {
  writeSetting(name, most)
  expect(readSetting<unknown>(name, 'preset')).toEqual(most)
  writeSetting(name, more)
  expect(readSetting<unknown>(name, 'preset')).toBe('preset')
})

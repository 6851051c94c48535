import { beforeAll, expect, test } from 'vitest'
import { wordsIn, fetchInAll, hasMessage } from '#words/message.ts'
import { choices, laneOf, looks, settingsOf, type Setting } from './lanes.ts'

const racers = ['q', 'sarsa', 'best', 'random'] as const
beforeAll(() => fetchInAll('races'))

test('every choice of every setting is a word in German and in English', () => {
  for (const [setting, all] of Object.entries(choices)) {
    expect(hasMessage(`race.setting.${setting}`), setting).toBe(true)
    for (const { word } of all)
      for (const locale of ['de', 'en'] as const) {
        const key = `race.choice.${word}`
        expect(wordsIn(locale)(key), `${setting} ${word} ${locale}`).not.toBe(key)
      }
  }
})

test('every racer starts with choices that it has: how it learns and how it counts what comes next', () => {
  for (const racer of racers) {
    const lane = laneOf(racer)
    const settings = settingsOf(racer)
    for (const setting of settings) {
      const values: readonly number[] = choices[setting].map(({ value }) => value)
      expect(values, `${racer} ${setting}`).toContain(lane[setting])
    }
    const shared: readonly Setting[] = ['alpha', 'gamma', 'nu']
    expect(settings.filter((one) => one !== 'rho')).toEqual(shared)
  }
})

test('no two lanes have the same colour or the same shape', () => {
  for (const part of ['colour', 'mark'] as const)
    expect(new Set(looks.map((look) => look[part])).size).toBe(looks.length)
})

// Every cage of the zoo of sensors is held to the same rules merely because its folder is there.
import { readFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { isCage, learnIn, mendedIn, shownIn, type Place } from '@botgarten/experiments/cages'
import { createLab } from '@botgarten/lab'
import { languagesOf } from '@botgarten/messages/folder'
import { sample } from '@botgarten/numbers/testing'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { gradeOf } from '../items/readability.ts'
import { readCageRows, readSenseCage } from '../schema/senseCage.ts'

describe.each(content.senseCages.map((one) => [one.cage.id, one] as const))(
  '%s',
  (_, { cage, rows, text }) => {
    const world = content.world(cage.world)!
    const place: Place = {
      worlds: cage.starts.map((pose) => ({ ...world, robots: [{ ...world.robots[0]!, pose }] })),
      floor: content.floorOf(world),
    }
    const { shown, bos } = rows

    it('is measured with 20 seeds, and the robot that is watched is the first that cheats, if any does', () => {
      expect(bos.map(({ seed }) => seed)).toEqual(Array.from({ length: 20 }, (__, k) => k + 1))
      expect(shown.seed).toBe(bos.find(({ cheats }) => cheats)?.seed ?? 1)
    })

    const seeds = [shown.seed, ...bos.map(({ seed }) => seed).filter((seed) => seed !== shown.seed)]

    it.each(sample(seeds, 1))('seed %i learns and does again what its row says', (seed) => {
      const { table, measured, cheats } = learnIn(cage, place, seed)
      expect(bos.find((bo) => bo.seed === seed)).toMatchObject({ ...measured, cheats })
      if (seed === shown.seed) expect(table).toEqual(shownIn(cage, rows))
    })

    it.each(sample(seeds, 0))('seed %i comes to what its row says with the mended pay', (seed) => {
      expect(mendedIn(cage, place, seed)).toBe(bos.find((bo) => bo.seed === seed)!.mended)
    })

    it('a cage is mended by its mend for most of its robots', () => {
      if (isCage(bos))
        expect(2 * bos.filter(({ mended }) => mended !== null).length).toBeGreaterThan(bos.length)
    })

    it('has a picture of its own animal', () => {
      const picture = content.pictureOfSenseCage(cage.id)
      expect(readFileSync(picture, 'utf8')).toMatch(/<svg /)
      const beside = readFileSync(join(dirname(picture), 'cage.json'), 'utf8')
      expect(readSenseCage(JSON.parse(beside)).id).toBe(cage.id)
    })

    it('has free starts', () => {
      const lab = createLab()
      lab.load({ programs: {}, brains: {}, world }, place.floor, { seed: 1, checks: [] })
      for (const start of cage.starts) {
        const { x, y } = lab.place(world.robots[0]!.id, start)
        expect([x, y]).toEqual([start.x, start.y])
      }
    })

    it.each(languagesOf(text))(
      'has its words in "%s", as simple as its youngest reader needs them',
      (language) => {
        const { title, guess, does, hints, ...sentences } = text[language]!
        expect(title).toMatch(/\S/)
        const all = [...Object.values(guess), ...Object.values(does), ...Object.values(sentences), ...hints]
        expect(gradeOf(all.join('\n'), language) ?? 0).toBeLessThanOrEqual(5)
      },
    )
  },
)

describe('the zoo of sensors', () => {
  it('has cages, and riddles among which is the robot that has learned to be afraid', () => {
    const cages = content.senseCages.filter(({ rows }) => isCage(rows.bos))
    const riddles = content.senseCages.filter(({ rows }) => !isCage(rows.bos)).map(({ cage }) => cage.id)
    expect(cages.length).toBeGreaterThanOrEqual(3)
    expect(riddles).toEqual(expect.arrayContaining(['afraid', 'lurker']))
  })

  it.each([
    ['pay beyond 20 coins', { pay: [{ for: 'bump', coins: 1e6 }] }],
    ['pay of 0 everywhere', { pay: [{ for: 'bump', coins: 0 }] }],
    ['pay for what nobody knows', { pay: [{ for: 'hunger', coins: 1 }] }],
    ['seven sentences', { pay: Array.from({ length: 7 }, () => ({ for: 'bump', coins: -1 })) }],
    ['no sensor', { sensors: [], edges: [] }],
    ['over 200 states', { edges: [Array.from({ length: 50 }, (_, k) => k), [1, 2, 3, 4, 5]] }],
    ['one action', { actions: [{ left: 50, right: 50 }] }],
    ['a move that never ends', { hold: 1e9 }],
  ])('%s is refused', (_, odd) => {
    const { cage } = content.senseCages[0]!
    expect(readSenseCage(cage)).toEqual(cage)
    expect(() => readSenseCage({ ...cage, trial: { ...cage.trial, ...odd } })).toThrow(
      expect.objectContaining({ name: 'ValiError' }),
    )
  })

  it('a cage without a name for its cheat, and rows without robots, are refused', () => {
    const { cage, rows } = content.senseCages[0]!
    expect(() => readSenseCage({ ...cage, cheats: {} })).toThrow('its cheat')
    expect(() => readCageRows({ ...rows, bos: [] })).toThrow()
  })
})

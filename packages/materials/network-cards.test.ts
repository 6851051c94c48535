import { globSync, readFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { createLab } from '@botgarten/lab'
import { paintFloor, readPng, TICKS_PER_SECOND, type RobotConfig, type World } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { cardDocument, readCard, type CardProgram } from './index.ts'

// No robot is like another: solutions hold with sensors and wheels that err by 10 percent.
const content = join(import.meta.dirname, '../../content')
const read = (...path: string[]): unknown => JSON.parse(readFileSync(join(...path), 'utf8'))
const cards = ['02-incognito', '03-caution', '04-loud-distance', '07-interest', '08-rally']
const seeds = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]

const wheels: readonly Pick<RobotConfig, 'strength'>[] = [
  { strength: { left: 1, right: 1 } },
  { strength: { left: 0.9, right: 1 } },
  { strength: { left: 1, right: 0.9 } },
  { strength: { left: 0.9, right: 0.9 } },
  { strength: { left: 1.1, right: 1.1 } },
]

describe.each(globSync(cards.map((card) => join(content, 'cards/network', card, 'card.json'))))(
  'the solution of %s',
  (file) => {
    const card = readCard(read(file))
    const world = read(content, 'worlds', card.world, 'world.json') as World
    const asset = 'asset' in world.floor ? world.floor.asset.replace('content:', '') : ''
    const floor = paintFloor(world, readPng(readFileSync(join(content, asset))))
    const program = read(dirname(file), 'solution.json') as CardProgram

    function open(start: number, seed: number, errors: Partial<RobotConfig>): string[] {
      const document = cardDocument(world, card, program, start)
      const [robot, ...others] = document.world.robots
      const robots = [{ ...robot!, config: { ...robot!.config, ...errors } }, ...others]
      const lab = createLab()
      lab.load({ ...document, world: { ...document.world, robots } }, floor, { seed, checks: card.checks })
      lab.start()
      lab.advance(Math.max(60, ...card.checks.map(({ seconds }) => seconds)) * TICKS_PER_SECOND)
      return lab
        .view()
        .checks.filter(({ passed }) => !passed)
        .map(({ id }) => id)
    }

    it.each(card.starts.map((_, start) => start))(
      'holds from start pose %i on ten seeds with noise',
      (start) => {
        expect(seeds.flatMap((seed) => open(start, seed, { noise: 10 }))).toEqual([])
      },
    )

    it.each(card.starts.map((_, start) => start))('holds from start pose %i with unlike wheels', (start) => {
      expect(wheels.flatMap((errors) => open(start, 1, { ...errors, noise: 10 }))).toEqual([])
    })
  },
)

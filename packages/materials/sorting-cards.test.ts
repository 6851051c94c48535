import { globSync, readFileSync } from 'node:fs'
import { basename, dirname, join } from 'node:path'
import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/learning'
import { createLab } from '@botgarten/lab'
import { sample } from '@botgarten/numbers/testing'
import { paintFloor, TICKS_PER_SECOND, type World } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { cardDocument, readCard, type CardProgram } from './index.ts'

addBlocks(learning)
const content = join(import.meta.dirname, '../../content')
const read = (...path: string[]): unknown => JSON.parse(readFileSync(join(...path), 'utf8'))
const seeds = sample([1, 2, 3, 4, 5, 6, 7, 8, 9, 10], 1)

// The sensor of these worlds is noisy: another seed is another run.
describe.each(globSync(join(content, 'cards/sorting/*/card.json')).map(dirname))('%s', (folder) => {
  const card = readCard(read(folder, 'card.json'))
  const world = read(content, 'worlds', card.world, 'world.json') as World

  function runWith(seed: number, file: string, start: number) {
    const document = cardDocument(world, card, read(folder, file) as CardProgram, start)
    const lab = createLab()
    lab.load(document, paintFloor(world), { seed, checks: card.checks })
    lab.start()
    lab.advance(60 * TICKS_PER_SECOND)
    return {
      passed: lab.view().checks.every(({ passed }) => passed),
      readings: lab.state().threads[0]!.sorting.readings,
    }
  }

  it('the noise of two seeds is not the same', () => {
    expect(runWith(1, 'solution.json', 0).readings).not.toEqual(runWith(2, 'solution.json', 0).readings)
  })

  it.each(seeds)('the solution passes with seed %i from every start pose', (seed) => {
    for (const start of card.starts.keys()) expect(runWith(seed, 'solution.json', start).passed).toBe(true)
  })

  it.each(globSync(join(folder, 'wrong/*.json')).map((file) => basename(file)))(
    'the wrong answer %s is refused with every seed',
    (file) => {
      for (const seed of seeds) expect(runWith(seed, join('wrong', file), 0).passed).toBe(false)
    },
  )
})

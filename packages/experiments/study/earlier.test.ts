// Logs that earlier versions wrote: e2e/samples.ts made them in a browser, at the commit that is the name of the file.
import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { content } from '@botgarten/content/files'
import { expect, test } from 'vitest'
import { isSame, readLog, replay, tableOf } from './index.ts'

const folder = join(import.meta.dirname, 'samples')

test.each(readdirSync(folder))('the study log %s opens, and its runs come to the same hashes', (name) => {
  const { lines, faults } = readLog(readFileSync(join(folder, name), 'utf8'))
  expect(faults).toEqual([])
  expect(tableOf(lines)).toMatchObject([{ pseudonym: '0102X', tries: 1, knobs: 1 }])
  const played = replay(lines, {
    floorOf: (world) => content.floorOf(world),
    checksOf: (place) => content.card(place)?.card.checks ?? [],
  })
  expect(played.faults).toEqual([])
  expect(played.runs).toHaveLength(1)
  expect(played.runs.filter((run) => !isSame(run) || run.ticks === 0)).toEqual([])
})

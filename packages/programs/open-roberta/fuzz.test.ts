import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { isLong } from '@botgarten/numbers/testing'
import { timed } from '@botgarten/numbers/testing/processor'
import { expect, it } from 'vitest'
import { completeLanguages, wordsOf } from '@botgarten/messages/folder'
import { ProjectError } from '../index.ts'
import { givenFiles, mutated, opened } from '../testing/mutations.ts'

addBlocks(expert)

const words = completeLanguages.map((language) => wordsOf(language))

const copies = isLong ? 500 : 100

it(`${copies} mutated copies are opened, or refused with a clear word, each within a second`, () => {
  const files = givenFiles()
  const counts = { opened: 0, refused: 0 }
  for (let number = 1; number <= copies; number++) {
    const { what, text } = mutated(files, number)
    const { result: outcome, seconds } = timed(() => opened(text))
    expect(seconds, what).toBeLessThan(1)
    if (outcome instanceof ProjectError) {
      counts.refused++
      for (const said of words) expect(Object.keys(said), what).toContain(`problem.${outcome.reason}.title`)
    } else counts.opened++
  }
  expect(counts.opened).toBeGreaterThan(copies / 5)
  expect(counts.refused).toBeGreaterThan(copies / 5)
}, 120_000)

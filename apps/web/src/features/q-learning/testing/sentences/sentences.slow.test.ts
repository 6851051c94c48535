import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { content } from '@botgarten/content/files'
import { kinds } from '@botgarten/lab'
import { learningIn } from '@botgarten/programs'
import { afterAll, beforeAll, describe, expect, test } from 'vitest'
import { sentenceOf } from '#features/missed/sentence.ts'
import type { Learning } from '#features/q-learning/model/learning.svelte.ts'
import { shownOf } from '#features/q-learning/model/shown.ts'
import { driveOf, endOf, liveSentence, reasonOf, tieOf } from '#features/q-learning/view/messages.ts'
import type { Notice } from '#lab/ui.svelte.ts'
import { courseOn, type Stage } from '#figures/map/stage.ts'
import { isShortest, sectionsOf } from '@botgarten/maps'
import { language } from '#words/language.svelte.ts'
import { fetchWords, m, message } from '#words/message.ts'
import { missedIn, rare } from './facts.ts'
import { faultsIn } from './faults.ts'

addBlocks(learning)
addBlocks(expert)

const missed = [...content.cards.flatMap(({ id }) => missedIn(id)), ...rare]
const ways = Object.entries(kinds).flatMap(([kind, { lacks }]) => lacks.map((what) => `${kind} ${what}`))

/** Sentences that have a fault, each with the name of it. */
const faulty = (sentences: readonly string[], locale: string) =>
  [...new Set(sentences)].flatMap((text) => faultsIn(text, locale).map((fault) => `${fault}: ${text}`))

test('every kind of miss that a check has comes up', () => {
  const seen = missed.map(({ kind, what }) => `${kind} ${what}`)
  expect(ways.filter((way) => !seen.includes(way))).toEqual([])
})

/** A learning on a map after `episodes` tries, as its notes read it. */
function learningOn(map: string, episodes: number, seed: number, from?: number): Learning {
  const stage = { id: map, map: content.mapFile(map)!, roads: [] } as unknown as Stage
  const outline = learningIn(content.program('railway', 'solution')!.programs['main']!)!
  const { start = 0, goal = stage.map.map.actions.length - 1 } = stage.map
  const asked = { ...outline, map, start: from ?? start, goal: from ?? goal, closed: [], episodes }
  const course = courseOn(stage, asked, seed)!
  course.advance(asked.moves)
  return {
    ...{ outline: asked, stage, shown: shownOf(course), shortest: sectionsOf(course), state: 'over' },
    isShortest: (stations: readonly number[]) => isShortest(course, stations),
    ...{ session: { lab: { speed: 1 } }, player: { speed: 1 } },
  } as unknown as Learning
}

const notices: readonly Notice[] = ['away', 'bumped', 'elsewhere', 'floorMissing']
const learnings = content.maps.flatMap((map) =>
  [1, 2, 10, 100, 1000]
    .flatMap((episodes) => [1, 2, 3].map((seed) => learningOn(map, episodes, seed)))
    .concat(
      // Start and goal are one station.
      learningOn(map, 10, 1, 1),
    ),
)

describe.each(['de', 'en'] as const)('in %s', (locale) => {
  beforeAll(async () => {
    await language.speak(locale)
    await fetchWords('missed', 'q-learning')
  })
  afterAll(() => language.speak('en'))

  test('what runs have missed is a sentence without a fault', () => {
    const sentences = missed.flatMap((one) => ['flag', ''].map((place) => sentenceOf(one, place)))
    expect(faulty(sentences, locale)).toEqual([])
  })

  test('so are the notes on what was learned, on every map', () => {
    const sentences = learnings.flatMap((one) => [
      ...[
        endOf(one),
        reasonOf(one, 'starter'),
        reasonOf(one, 'expert'),
        liveSentence(one),
        driveOf(one).text,
      ],
      tieOf(one).replace(/^ · /, ''),
    ])
    expect(faulty(sentences, locale)).toEqual([])
  })

  test('so are the notices below the world', () => {
    expect(
      faulty(
        notices.map((notice) => message(`session.${notice}`)),
        locale,
      ),
    ).toEqual([])
  })

  test('so are numbers in counted messages, from none to many', () => {
    const counted = [0, 1, 2, 21, 1000].flatMap((count) => [
      m['q.byEpisodes']({ count }),
      m['q.byTime']({ count }),
    ])
    expect(faulty(counted, locale)).toEqual([])
  })
})

import { kinds } from '@botgarten/lab'
import { ownKinds } from '@botgarten/programs'
import { afterAll, beforeEach, describe, expect, test } from 'vitest'
import { goalOf } from '#content/own-card.ts'
import { language } from '#words/language.svelte.ts'
import { fetchWords, message } from '#words/message.ts'
import { sentenceOf } from './sentence.ts'

afterAll(() => language.speak('en'))

describe.each(['en', 'de'] as const)('in %s', (locale) => {
  beforeEach(async () => {
    await language.speak(locale)
    await fetchWords('own-card', 'own-cards')
  })

  test.each(Object.entries(ownKinds))(
    '%s: every number is asked once in its sentence',
    (kind, { asks, lasts }) => {
      const names = sentenceOf(kind).flatMap((piece) => (typeof piece === 'string' ? [] : piece.name))
      expect(names.toSorted()).toEqual([...Object.keys(asks), ...(lasts ? ['seconds'] : [])].toSorted())
      for (const name of names) expect(message(`cards.number.${name}`)).not.toMatch(/^cards\./)
      expect(message(`cards.kind.${kind}`)).not.toMatch(/^cards\./)
    },
  )

  test.each(Object.keys(ownKinds))('%s: has a goal in few words', (kind) => {
    const numbers = Object.fromEntries(kinds[kind]!.needs.map((name) => [name, '1']))
    const goal = goalOf({ id: kind, kind, numbers, seconds: 1 }, { obstacles: [] })
    expect(goal).toMatch(/^\S.{2,40}$/)
    expect(goal).not.toMatch(/[{}]|card\./)
  })
})

import { content } from '@botgarten/content/files'
import { createLab, kinds, type Missing } from '@botgarten/lab'
import { cardProject } from '@botgarten/content'
import { fetchWords } from '#words/message.ts'
import { language } from '#words/language.svelte.ts'
import { afterAll, beforeEach, describe, expect, test } from 'vitest'
import { sentenceOf } from './sentence.ts'

/** A fact of every name that a kind may give. */
const facts: Missing['facts'] = {
  ...{ away: 120, seconds: 2.5, needed: 5, colour: '#F7D117', other: '#B30006', shone: 'red', lamp: 'green' },
  ...{ thing: 'square', seen: 2, all: 4, passed: 3, speed: 60, least: 50, most: 45, light: 80, words: 2 },
  ...{ animal: 'gazer', told: 1, kinds: 3, hertz: 50, bumps: 2, off: 12.5, word: 'yellow' },
}

afterAll(() => language.speak('en'))

describe.each(['en', 'de'] as const)('in %s', (locale) => {
  beforeEach(async () => {
    await language.speak(locale)
    await fetchWords('missed')
  })

  const ways = Object.entries(kinds).flatMap(([kind, { lacks }]) =>
    lacks.map((what) => [kind, what] as const),
  )
  test.each(ways)('%s, %s: there is a whole sentence for it, with and without a flag', (kind, what) => {
    for (const place of ['flag', '']) {
      const said = sentenceOf({ check: '', kind, what, facts }, place)
      expect(said).toMatch(/^[A-ZÄÖÜ].*\.$/)
      expect(said).not.toMatch(/[{}]|missed\./)
    }
  })

  // Only facts that a kind gives are in its sentences.
  test.each(content.cards.map(({ id }) => id))(
    '%s, left as it begins, lacks something that is said',
    (id) => {
      const { card, start, world } = {
        ...content.card(id)!,
        world: content.world(content.card(id)!.card.world)!,
      }
      const project = cardProject(world, card, start, id)
      const lab = createLab()
      lab.load(project, content.floorOf(project.world), { seed: 1, checks: card.checks })
      lab.start()
      lab.advance(240)
      lab.stop()
      for (const one of lab.missing()) {
        expect(card.checks.map((check) => check.id)).toContain(one.check)
        expect(sentenceOf(one, '')).not.toMatch(/[{}]|missed\./)
      }
    },
  )
})

test('the straight path, left as it begins: fifty centimetres driven of a metre seventy', async () => {
  const { card, start } = content.card('forward')!
  const project = cardProject(content.world(card.world)!, card, start, 'forward')
  const lab = createLab()
  lab.load(project, content.floorOf(project.world), { seed: 1, checks: card.checks })
  lab.start()
  lab.advance(1200)
  const [one] = lab.missing()
  await language.speak('en')
  expect(sentenceOf(one!, 'flag')).toBe('Bo stopped 1.2 m before the flag.')
  await language.speak('de')
  expect(sentenceOf(one!, 'flag')).toBe('Bo hat 1,2 m vor der Fahne gehalten.')
})

import { content } from '@botgarten/content/files'
import { createLab, kinds, type Missing } from '@botgarten/lab'
import { cardProject } from '@botgarten/content'
import { distance } from '#figures/world/distance.ts'
import { fetchWords, message } from '#words/message.ts'
import { language } from '#words/language.svelte.ts'
import { afterAll, beforeEach, describe, expect, test } from 'vitest'
import { sentenceOf } from './sentence.ts'

/** A fact of every name that a kind may give. */
const facts: Missing['facts'] = {
  ...{ away: 120, seconds: 2.5, needed: 5, colour: '#F7D117', other: '#B30006', shone: 'red', lamp: 'green' },
  ...{ thing: 'square', seen: 2, all: 4, passed: 3, speed: 60, least: 50, most: 45, light: 80, words: 2 },
  ...{ animal: 'gazer', told: 1, kinds: 3, hertz: 50, bumps: 2, off: 12.5, word: 'yellow' },
  ...{ from: 4, to: 6 },
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
  expect(sentenceOf(one!, 'flag')).toBe('Bo stopped 1.2\u00a0m before the flag.')
  await language.speak('de')
  expect(sentenceOf(one!, 'flag')).toBe('Bo hat 1,2\u00a0m vor der Fahne gehalten.')
})

describe('facts are read', () => {
  beforeEach(async () => {
    await language.speak('en')
    await fetchWords('missed')
  })
  const said = (kind: string, what: string, facts: Missing['facts']) =>
    sentenceOf({ check: '', kind, what, facts }, '')

  test('as lengths where the limits of a kind are lengths: whole centimetres, or tenths of a metre', () => {
    const lengths = { least: distance(230), most: distance(45) }
    expect(said('cruises', 'slow', { most: 45, least: 230 })).toBe(message('missed.cruises.slow', lengths))
    expect(said('sings', 'near', { most: 45 })).toBe(message('missed.sings.near', lengths))
    expect(said('turnsAway', 'stayed', { thing: 'wall', away: 45, least: 230 })).toBe(
      message('missed.turnsAway.stayed', { thing: 'wall', away: distance(45), least: distance(230) }),
    )
    expect(said('speedOn', 'slow', { colour: '#F7D117', speed: 20, least: 50 })).toBe(
      message('missed.speedOn.slow', { colour: message('missed.colour.yellow'), speed: 20, least: 50 }),
    )
  })

  test('with one digit below ten, as whole numbers from ten on', () => {
    const wanted = (seconds: string, needed: string) => message('missed.stays.short', { seconds, needed })
    expect(said('stays', 'short', { seconds: 9.94, needed: 10.4 })).toBe(wanted('9.9', '10'))
    expect(said('stays', 'short', { seconds: 2.46, needed: 10 })).toBe(wanted('2.5', '10'))
    expect(said('cruises', 'short', { seconds: 10.04, needed: 30 })).toBe(
      message('missed.cruises.short', { seconds: '10', needed: '30' }),
    )
  })

  test('as words, and a colour that no sensor tells apart as the plain floor', () => {
    expect(said('silent', 'spoke', { colour: '#123456', word: 'hello' })).toBe(
      message('missed.silent.spoke', { colour: message('missed.colour.none'), word: 'hello' }),
    )
  })
})

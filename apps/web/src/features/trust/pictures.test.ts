import { afterAll, beforeEach, describe, expect, test } from 'vitest'
import { language } from '#words/language.svelte.ts'
import { fetchWords } from '#words/message.ts'
import { systems } from './pictures.ts'

afterAll(() => language.speak('en'))

describe.each(['en', 'de'] as const)('in %s', (locale) => {
  beforeEach(async () => {
    await language.speak(locale)
    await fetchWords('trust')
  })

  test('six systems are told how to trust the server in three steps, and how to undo that', () => {
    expect(systems().map(({ name, steps }) => [name, steps.length])).toEqual(
      ['Windows', 'iPadOS', 'Android', 'ChromeOS', 'macOS'].map((name) => [name, 3]),
    )
    const sentences = systems().flatMap(({ remove, steps }) => [remove, ...steps.map(({ text }) => text)])
    for (const sentence of sentences) expect(sentence).toMatch(/^[^{}]+[.:)]$/)
    expect(sentences.filter((sentence) => sentence.startsWith('trust.'))).toEqual([])
    expect(new Set(sentences).size).toBe(sentences.length)
  })

  test('in every picture one thing is pressed, and all but lines and devices of a school have a name', () => {
    for (const { picture } of systems().flatMap(({ steps }) => steps)) {
      const { rows, frame } = picture
      expect(['window', 'settings', 'browser']).toContain(frame)
      expect(rows.filter(({ pressed }) => pressed)).toHaveLength(1)
      for (const { kind, label } of rows) {
        expect(['line', 'button', 'option', 'switch', 'entry', 'file', 'device']).toContain(kind)
        if (kind !== 'line' && kind !== 'device') expect(label).toMatch(/^(?!trust\.)./)
        if (kind === 'device') expect(label).toBe('')
        if (kind === 'file') expect(label).toBe('botgarten.crt')
      }
    }
  })
})

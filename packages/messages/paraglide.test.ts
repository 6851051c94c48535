// `fill` against Paraglide, an independent implementation of the same message format.
import { readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import { completeLanguages } from './folder.ts'
import { fill } from './message.ts'
import { casesOf, changingIn, fingerprintOf, referenceFile, type Reference } from './testing/paraglide.ts'

const { sentences } = JSON.parse(readFileSync(referenceFile, 'utf8')) as Reference

describe.each(completeLanguages)('sentences that change with a number, in "%s"', (locale) => {
  const compiled = Object.entries(sentences[locale] ?? {})

  test('are those that Paraglide compiled last (else: npm run paraglide)', () => {
    const fingerprints = Object.entries(changingIn(locale)).map(([key, message]) => [
      key,
      fingerprintOf(message),
    ])
    expect(Object.fromEntries(compiled.map(([key, [fingerprint]]) => [key, fingerprint]))).toEqual(
      Object.fromEntries(fingerprints),
    )
  })

  test('are filled as Paraglide fills them', () => {
    expect(compiled.length).toBeGreaterThan(20)
    const table = changingIn(locale)
    for (const [key, [, ...expected]] of compiled) {
      const message = table[key]
      // A message that was deleted or renamed: the test above reports it.
      if (message === undefined) continue
      expect(
        casesOf(message).map((facts) => fill(message, facts, locale)),
        key,
      ).toEqual(expected)
    }
  })
})

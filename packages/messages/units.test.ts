import { describe, expect, it } from 'vitest'
import { completeLanguages, wordsOf } from './folder.ts'
import type { Message } from './message.ts'

const seconds = /^(s|Sekunden?|seconds?)\b/
const percent = /^(%|Prozent|percent|(von|of) 100)/
const centimetres = /^cm\b/

/** Placeholders that are a length, a time, an angle, a share or a speed, and the units that may follow. */
const units: { readonly [placeholder: string]: RegExp } = {
  seconds,
  minutes: /^(Min\.|min\b|Minuten?\b|(more )?minutes?\b)/,
  percent,
  off: percent,
  degrees: /^(°|Grad|degrees?\b)/,
  hertz: /^(Hz|Hertz|hertz)/,
  cm: centimetres,
  near: centimetres,
  far: centimetres,
  length: /^(cm|m)\b/,
  speed: /^(%|×)/,
  heading: /^°/,
  DEGREE: /^°/,
  DISTANCE: centimetres,
  DURATION: /^ms\b/,
  FREQUENCE: /^Hz/,
  POWER: /^%/,
  WAIT: /^ms\b/,
}

/** A limit has a unit, too, where one of these is limited. */
const limits: readonly string[] = ['needed', 'most', 'least']
const limited: readonly string[] = ['seconds', 'off', 'hertz', 'speed']
const anyUnit = /^(s|%|Prozent|percent|Hz)(?![a-z])/

/** Placeholders whose value includes its unit, or is none of these. */
const exempt: { readonly [key: string]: string } = {
  'call.noItem near': 'names of materials',
  'call.noPack near': 'names of packs',
  'block.mbedActions_play_note.row0 DURATION': 'the name of a note',
  'sorting.speed speed': 'written as 1×',
  'zoo.senses.each minutes': 'the unit is in front: minute 5',
}

const textsOf = (message: Message): readonly string[] =>
  typeof message === 'string' ? [message] : message.flatMap(({ match }) => Object.values(match))

/** Placeholders of a sentence that lack the unit behind them. Two may share one: "{x} to {y} cm". */
function bareIn(text: string): readonly string[] {
  const names = [...text.matchAll(/\{(\w+)\}/g)].map(([, name]) => name!)
  const isLimited = limited.some((name) => names.includes(name))
  return [...text.matchAll(/\{(\w+)\}(?:(?:,| bis| to)? \{\w+\})?[\s\u00a0-]?(.{0,12})/gs)].flatMap(
    ([, name, after]) => {
      const unit = isLimited && limits.includes(name!) ? anyUnit : units[name!]
      return unit && !unit.test(after!) ? [name!] : []
    },
  )
}

describe.each(completeLanguages)('in %s', (language) => {
  it('every length, time, angle, share and speed is followed by its unit', () => {
    const bare = Object.entries(wordsOf(language)).flatMap(([key, message]) =>
      textsOf(message).flatMap((text) => bareIn(text).map((name) => `${key} ${name}`)),
    )
    expect([...new Set(bare)].filter((one) => exempt[one] === undefined)).toEqual([])
  })
})

it('every exemption is needed', () => {
  const bare = completeLanguages.flatMap((language) =>
    Object.entries(wordsOf(language)).flatMap(([key, message]) =>
      textsOf(message).flatMap((text) => bareIn(text).map((name) => `${key} ${name}`)),
    ),
  )
  expect(Object.keys(exempt).filter((one) => !bare.includes(one))).toEqual([])
})

import { writeNumber } from '@botgarten/messages'
import senses from 'content:senses'
import type { LoadedSenseCage } from '@botgarten/content/catalogue'
import { countOf, isCage, type Measured } from '@botgarten/experiments/cages'
import { unitOf, type PayKind, type Sentence } from '@botgarten/learning/q-senses'
import { language } from '#words/language.svelte.ts'
import { m } from '#words/message.ts'

export const { senseCages, pictureOf } = senses

/** The words of a cage in the language of now; what is not translated yet is said in English. */
export const textOf = ({ text }: LoadedSenseCage) => text[language.locale] ?? text['en']!

/** What is paid for, as it stands behind “for”. */
export const kindNames: { readonly [kind in PayKind]: () => string } = {
  bump: m['zoo.senses.bump'],
  moment: m['zoo.senses.moment'],
  ahead: m['zoo.senses.ahead'],
  way: m['zoo.senses.way'],
  wheels: m['zoo.senses.wheels'],
  farther: m['zoo.senses.farther'],
  open: m['zoo.senses.open'],
  near: m['zoo.senses.near'],
  tile: m['zoo.senses.tile'],
  black: m['zoo.senses.black'],
  line: m['zoo.senses.line'],
  free: m['zoo.senses.free'],
}

/** A number in the language of now, with its sign: `+1`, `−5`. */
export const coins = (value: number): string => writeNumber(value, language.locale, { most: 2, plus: true })

export const whole = (value: number): string => writeNumber(Math.round(value), language.locale)

/** `4 cm ahead: +1 · a bump: −5` of a cage's pay. */
export const payOf = (pay: readonly Sentence[]): string =>
  pay.map(({ for: kind, coins: each }) => `${kindNames[kind]()}: ${coins(each * unitOf(kind))}`).join(' · ')

/** How many of the measured robots do it. */
export const howMany = ({ rows }: LoadedSenseCage) => ({ count: countOf(rows.bos), of: rows.bos.length })

export const isRiddle = ({ rows }: LoadedSenseCage) => !isCage(rows.bos)

/** The cage's own mend made none of them drive as is meant. */
export const isUnmended = ({ rows }: LoadedSenseCage) => rows.bos.every(({ mended }) => mended === null)

/** Numbers of one drive that tell cheats from driving. */
export const numbersOf = (measured: Measured) => [
  { label: m['zoo.senses.pay'](), value: measured.pay },
  { label: m['zoo.senses.cm'](), value: measured.cm },
  { label: m['zoo.senses.tiles'](), value: measured.tiles },
  { label: m['zoo.senses.touching'](), value: measured.touching },
]

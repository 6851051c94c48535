import { basename, dirname } from 'node:path'
import { content } from '@botgarten/content/files'
import type { Item } from '@botgarten/content/items'
import type { LoadedForm } from '@botgarten/content/questionnaires'
import { CallError } from '../errors.ts'
import { nearest } from './nearest.ts'

/** What can be printed. */
export interface Printable {
  /** As it is called in a call: `network-cards`, `questionnaire-after`. */
  readonly id: string
  /** Its file begins so: `card-01-network-cards`. */
  readonly file: string
  /** Where its page is, with what it is asked for besides paper. */
  readonly address: string
  /** Is it printed on A5, or two beside each other on A4? */
  readonly isCard: boolean
}

/** `worksheet-17-one-wire`; of another reading level `worksheet-17-one-wire-a`. */
function fileOf({ id, kind }: Item): string {
  const folder = content.itemFolder(id)
  const name = basename(folder)
  return `${kind}-${name.length === 1 ? `${basename(dirname(folder))}-${name}` : name}`
}

const printableItem = (item: Item): Printable => ({
  ...{ id: item.id, file: fileOf(item) },
  ...{ address: `/materials/${item.kind}/${item.id}?`, isCard: item.paper === 'a5' },
})

/** Packs by what they are called in a call: `lesson-3`, `lesson-e7`, `double-a`, `no-network`. */
const packs = (): ReadonlyMap<string, string> =>
  new Map([
    ...content.items.flatMap(({ id, plan }) =>
      plan ? [[`lesson-${plan.lesson.toLowerCase().replace(' ', '')}`, id] as const] : [],
    ),
    ...content.items.flatMap(({ plan }) => {
      const double = plan?.double && `double-${plan.double.name.toLowerCase()}`
      return double ? [[double, double] as const] : []
    }),
    ...content.packs.map(({ id }) => [id, id] as const),
  ])

/** A class that something is printed for; without a grade sheets are those of the middle reading level. */
export interface Class {
  readonly pupils: number
  readonly grade: number | null
  /** All of it so many times. */
  readonly sets: number
}

/** A pack for so many pupils is two files: what is copied, and answers apart, where it has some. */
function printablePack(name: string, id: string, { pupils, grade, sets }: Class): readonly Printable[] {
  const plan = content.items.find((item) => item.id === id)?.plan
  const copied = new Set(plan?.copies.map(({ of }) => of))
  const hasAnswers =
    id.startsWith('double-') ||
    content.items.some(
      (item) =>
        item.kind === 'solution' && (item.code === `A ${plan?.lesson}` || copied.has(`item:${item.id}`)),
    )
  const forGrade = grade === null ? '' : `&grade=${grade}`
  const file = (answers: string) =>
    `/materials/pack/${id}?children=${pupils}&sets=${sets}&answers=${answers}${forGrade}&`
  const pack = { id: name, file: `pack-${name}`, address: file('apart'), isCard: true }
  return hasAnswers
    ? [pack, { ...pack, id: `${name}-answers`, file: `pack-${name}-answers`, address: file('only') }]
    : [pack]
}

/** What `print pack …` names. @throws CallError with the nearest names for what is not there */
export function packsNamed(names: readonly string[], asked: Class): readonly Printable[] {
  const all = packs()
  return names.flatMap((name) => {
    const id = all.get(name)
    if (id) return printablePack(name, id, asked)
    throw new CallError('call.noPack', { name, near: nearest(name, [...all.keys()]).join(', ') })
  })
}

/** A form is two: with numbers, and with faces for those who have just learned to read. */
const printableForm = ({ form }: LoadedForm): readonly Printable[] =>
  ['', '-young'].map((face) => ({
    ...{ id: `questionnaire-${form.id}${face}`, file: `questionnaire-${form.id}${face}` },
    address: `/questionnaires?form=${form.id}&show=paper${face && '&for=young'}&`,
    isCard: false,
  }))

/** All items in the order of their folders, then all forms. */
const allPrintable = (): readonly Printable[] => [
  ...content.items.map(printableItem),
  ...content.forms.flatMap(printableForm),
]

/** What a call names. @throws CallError with the nearest names for what is not there */
export function printablesNamed(names: readonly string[]): readonly Printable[] {
  const all = allPrintable()
  if (names.includes('all')) return all
  return names.map((name) => {
    const found = all.find(({ id }) => id === name)
    if (found) return found
    const near = nearest(
      name,
      all.map(({ id }) => id),
    )
    throw new CallError('call.noItem', { name, near: near.join(', ') })
  })
}

import { basename } from 'node:path'
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

const printableItem = ({ id, kind, paper }: Item): Printable => ({
  ...{ id, file: `${kind}-${basename(content.itemFolder(id))}` },
  ...{ address: `/materials/${kind}/${id}?`, isCard: paper === 'a5' },
})

/** Packs by what they are called in a call: `lesson-3`, `lesson-e7`, `no-network`. */
const packs = (): ReadonlyMap<string, string> =>
  new Map([
    ...content.items.flatMap(({ id, plan }) =>
      plan ? [[`lesson-${plan.lesson.toLowerCase().replace(' ', '')}`, id] as const] : [],
    ),
    ...content.packs.map(({ id }) => [id, id] as const),
  ])

/** A pack for so many pupils is two files: what is copied, and answers apart, where it has some. */
function printablePack(name: string, id: string, pupils: number): readonly Printable[] {
  const plan = content.items.find((item) => item.id === id)?.plan
  const copies = plan?.copies ?? content.packs.find((pack) => pack.id === id)!.copies
  const hasAnswers = copies.some(
    ({ of }) => content.items.find((item) => `item:${item.id}` === of)?.kind === 'solution',
  )
  const file = (answers: string) => `/materials/pack/${id}?children=${pupils}&answers=${answers}&`
  const pack = { id: name, file: `pack-${name}`, address: file('apart'), isCard: true }
  return hasAnswers
    ? [pack, { ...pack, id: `${name}-answers`, file: `pack-${name}-answers`, address: file('only') }]
    : [pack]
}

/** What `print pack …` names. @throws CallError with the nearest names for what is not there */
export function packsNamed(names: readonly string[], pupils: number): readonly Printable[] {
  const all = packs()
  return names.flatMap((name) => {
    const id = all.get(name)
    if (id) return printablePack(name, id, pupils)
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

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

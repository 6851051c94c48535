import type { Selectable } from 'kysely'

/** A form that a class was asked. */
interface AskingTable {
  /** 32 hexadecimal digits: who has them may answer. */
  key: string
  class: string
  /** Id of the form: a class is asked a form once, however often it is opened again. */
  form: string
  /** JSON: the form, its words and what is counted of it, as they were when it was first asked. */
  document: string
  grade: number
  /** ISO day on which it was first opened: of all its answers, so that none of them says when it came. */
  day: string
  /** `closing`: nobody begins any more, and what is on its way is taken. */
  state: 'open' | 'closing' | 'closed'
  /** When what is on its way has had its time, ms of the steady clock; only while closing. */
  closesAt: number | null
  /** Make and check tokens, hexadecimal. Null: it was opened before there were tokens, and takes answers without. */
  secretKey: string | null
  publicKey: string | null
}

/** A code that was chosen in a form that is open. Keyed hashes alone, no time and no order. */
interface CodeTable {
  asking: string
  /** Of the code. */
  code: string
  /** Of the id of the answer that has it. */
  owner: string
}

/** What one child answered. Nothing says who, and nothing says when. */
interface AnswerTable {
  asking: string
  /** By chance, made on the device. */
  id: string
  code: string | null
  /** JSON: what was chosen, by item. */
  chosen: string
}

/** Counts from sheets of paper. */
interface PaperTable {
  asking: string
  id: string
  /** JSON. */
  document: string
}

/** What of the answers of a class is published. */
interface PublishedTable {
  class: string
  /** JSON. */
  document: string
}

export interface AnswerTables {
  asking: AskingTable
  answer: AnswerTable
  code: CodeTable
  paper: PaperTable
  published: PublishedTable
}

export type AskingRow = Selectable<AskingTable>
export type AnswerRow = Selectable<AnswerTable>

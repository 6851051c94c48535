import { readFormFile, type LoadedForm } from '@botgarten/content/questionnaires'
import * as v from 'valibot'
import type { Permit } from './class-token.ts'
import { isKnown } from './forms.ts'

/** What a pupil's class is asked. */
export interface ClassQuestion {
  readonly key: string
  readonly grade: number
  /** Of the form, hexadecimal; null: it was opened before there were tokens. */
  readonly publicKey: string | null
  readonly loaded: LoadedForm
}

const answer = v.object({
  ...{ key: v.string(), grade: v.number(), form: v.unknown(), text: v.unknown() },
  publicKey: v.nullable(v.string()),
})

/** A form as the class server sends it. @throws ValiError for what is none */
export const formIn = ({ form, text }: { readonly form?: unknown; readonly text?: unknown }): LoadedForm =>
  readFormFile({ botgarten: 'form', version: 1, form, text })

/** What the class is asked now. `none`: nothing · `away`: the class cannot be reached, or asks what this page does not know. */
export async function askedNow(pupil: string): Promise<ClassQuestion | 'none' | 'away'> {
  try {
    const reply = await fetch('/api/class/me/questionnaire?tokens', { headers: { 'botgarten-pupil': pupil } })
    if (reply.status === 404) return 'none'
    if (!reply.ok) return 'away'
    const { key, grade, publicKey, ...form } = v.parse(answer, await reply.json())
    const loaded = formIn(form)
    return isKnown(loaded) ? { key, grade, publicKey, loaded } : 'away'
  } catch {
    return 'away'
  }
}

const reply = v.object({ taken: v.boolean() })

/** Has another child chosen this code? Asked without a cookie; where the class cannot be asked, nobody has. */
export async function isTakenInClass(key: string, permit: Permit, code: string): Promise<boolean> {
  try {
    const answered = await fetch('/api/class/answers/code', {
      ...{ method: 'POST', credentials: 'omit', body: JSON.stringify({ key, ...permit, code }) },
      headers: { 'content-type': 'application/json' },
    })
    return v.parse(reply, await answered.json()).taken
  } catch {
    return false
  }
}

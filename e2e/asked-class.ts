// A class that is asked a questionnaire, and children who answer by requests as devices send them.
import { randomBytes } from 'node:crypto'
import { answerIdOf, blindInput, tokenOf, type Evaluation } from '@botgarten/answers/tokens'
import { content } from '@botgarten/content/files'
import { nth } from './child-questionnaires.ts'
import type { MadeClass } from './made-class.ts'

export async function opensForm(made: MadeClass, form: string): Promise<void> {
  await made.teacher.ask('POST', `/classes/${made.id}/questionnaires`, { form })
}

/** A further pupil joins and gets the token for the form that is open. */
async function permitOf(made: MadeClass) {
  const { asker } = await made.pupil(`Kind ${randomBytes(3).toString('hex')}`)
  const { body } = await asker.ask('GET', '/me/questionnaire?tokens')
  const { key, publicKey } = body as { key: string; publicKey: string }
  const blinded = blindInput()
  const given = await asker.ask('POST', '/me/questionnaire/token', { key, blinded: blinded.blinded })
  const token = tokenOf(blinded, given.body as Evaluation, publicKey)
  return { key, id: answerIdOf(token), token }
}

/** The answers of a further pupil, without a cookie: those of the n-th child. */
export async function sends(made: MadeClass, form: string, n: number): Promise<number> {
  const { items } = content.forms.find((one) => one.form.id === form)!.form
  const values = Object.fromEntries(items.map((item) => [item.id, nth(n)(item)]))
  const sent = { ...(await permitOf(made)), code: `swan-${100 + n}`, values }
  const answer = await fetch(`${made.url}/api/class/answers`, {
    method: 'POST',
    headers: { origin: made.url, 'content-type': 'application/json' },
    body: JSON.stringify(sent),
  })
  return answer.status
}

/** So many answers are there, and the form is closed. */
export async function isAnswered(made: MadeClass, form: string, count: number): Promise<void> {
  await opensForm(made, form)
  for (let n = 0; n < count; n += 1) await sends(made, form, n)
  await made.teacher.ask('POST', `/classes/${made.id}/questionnaires/${form}/close`)
  passes(made, 2)
}

/** The server's clock goes on. */
export function passes({ classServer }: MadeClass, minutes: number): void {
  const { ports } = classServer
  const { now, steady } = ports
  const later = (clock: () => number) => () => clock() + minutes * 60_000
  Object.assign(ports, { now: later(now), steady: later(steady) })
}

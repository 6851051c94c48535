// A class that is asked a questionnaire, and children who answer by requests as devices send them.
import { randomBytes } from 'node:crypto'
import { content } from '@botgarten/content/files'
import { nth } from './child-questionnaires.ts'
import type { MadeClass } from './made-class.ts'

/** Opens a form. @returns its key, which pupils' devices get */
export async function opensForm(made: MadeClass, form: string): Promise<string> {
  await made.teacher.ask('POST', `/classes/${made.id}/questionnaires`, { form })
  const { asker } = await made.pupil(`Kind ${randomBytes(3).toString('hex')}`)
  const { body } = await asker.ask('GET', '/me/questionnaire')
  return (body as { key: string }).key
}

/** The n-th child's answers, without a cookie. */
export async function sends(made: MadeClass, key: string, form: string, n: number): Promise<number> {
  const { items } = content.forms.find((one) => one.form.id === form)!.form
  const values = Object.fromEntries(items.map((item) => [item.id, nth(n)(item)]))
  const sent = { key, id: randomBytes(16).toString('hex'), code: `swan-${100 + n}`, values }
  const answer = await fetch(`${made.url}/api/class/answers`, {
    method: 'POST',
    headers: { origin: made.url, 'content-type': 'application/json' },
    body: JSON.stringify(sent),
  })
  return answer.status
}

/** So many answers are there, and the form is closed. */
export async function isAnswered(made: MadeClass, form: string, count: number): Promise<void> {
  const key = await opensForm(made, form)
  for (let n = 0; n < count; n += 1) await sends(made, key, form, n)
  await made.teacher.ask('POST', `/classes/${made.id}/questionnaires/${form}/close`)
  passes(made, 2)
}

/** The server's clock goes on. */
export function passes({ classServer }: MadeClass, minutes: number): void {
  const { ports } = classServer
  const { now } = ports
  Object.assign(ports, { now: () => now() + minutes * 60_000 })
}

import { evaluateBlinded, type Evaluation } from '@botgarten/answers/tokens'
import * as v from 'valibot'
import { hashOf } from '../hashes.ts'
import { pupilOf } from '../joining/pupils-store.ts'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { askedIn } from './asked.ts'
import { askingOf, openAskingOf } from './askings-store.ts'
import { allowAgain, giveToken } from './tokens-store.ts'
import { element, formKeyOf } from './tokens.ts'

/** Requests that an evaluation counts as: it takes some 10 ms. */
const cost = 20

const blinded = v.strictObject({ key: v.string(), blinded: element })
const whom = v.strictObject({ pupil: v.pipe(v.string(), v.maxLength(64)) })

/** The form that is open for a pupil. A page of an earlier version, which does not fetch tokens, could not send the answers. */
async function mine({ ports, who, query }: Call<undefined>): Promise<Answer> {
  const asking = await openAskingOf(ports.database.answers.db, who.pupil!.class)
  if (!asking) throw new Refusal(404, 'noSuchForm')
  const { key, grade, publicKey } = asking
  if (publicKey !== null && !query.has('tokens')) throw new Refusal(409, 'oldPage')
  const { form, text } = askedIn(asking)
  return { body: { key, grade, form, text, publicKey } }
}

/** Evaluates the one input of a pupil for the form that is open. */
async function give({ ports, who, body }: Call<v.InferOutput<typeof blinded>>): Promise<Answer> {
  const { id, class: classId } = who.pupil!
  ports.limits.request(id, cost)
  const { db, answers } = ports.database
  const asking = await openAskingOf(answers.db, classId)
  const key = asking?.key === body.key ? formKeyOf(asking) : null
  if (!asking || !key) throw new Refusal(404, 'noSuchForm')
  const evaluation = evaluated(() => evaluateBlinded(key, body.blinded, ports.random))
  if (!(await giveToken(db, id, asking.form, hashOf(body.blinded)))) throw new Refusal(409, 'tokenGiven')
  return { body: evaluation }
}

function evaluated(evaluate: () => Evaluation): Evaluation {
  try {
    return evaluate()
  } catch {
    throw new Refusal(400, 'notUnderstood')
  }
}

/** The pupil's device has lost the token: the teacher allows another one, once. */
async function again({ ports, who, at, body }: Call<v.InferOutput<typeof whom>>): Promise<Answer> {
  const { id } = who.class!
  const { db, answers } = ports.database
  const asking = await askingOf(answers.db, id, at['form']!)
  if (!asking) throw new Refusal(404, 'noSuchForm')
  const pupil = await pupilOf(db, id, body.pupil)
  if (!pupil) throw new Refusal(404, 'noSuchPupil')
  if (!(await allowAgain(db, pupil.id, asking.form))) throw new Refusal(409, 'onceAgainOnly')
  return {}
}

export const tokenRoutes: readonly Route[] = [
  route('GET', '/me/questionnaire', ['pupil'], mine),
  route('POST', '/me/questionnaire/token', ['pupil'], give, blinded),
  route('POST', '/classes/:class/questionnaires/:form/again', ['owner'], again, whom),
]

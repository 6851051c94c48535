import * as v from 'valibot'
import { codeOf } from '../database/errors.ts'
import { EventStream } from '../live/event-stream.ts'
import type { RehearsalWish } from '../ports.ts'
import { Refusal } from '../refusal.ts'
import { route, type Call, type Route } from '../route.ts'

const whole = (least: number, most: number) =>
  v.pipe(v.number(), v.integer(), v.minValue(least), v.maxValue(most))
const wish = v.strictObject({ pupils: whole(1, 60), seconds: whole(1, 300) })

/**
 * Plays a lesson and tells how it goes: events `progress`, then `done` or `failed`. It belongs to its answer: who goes away
 * ends it. While anybody is in a class here it is refused, because it takes all that the machine has.
 */
function rehearse({ ports, body }: Call<RehearsalWish>): Promise<Response> {
  if (ports.live.size > 0) throw new Refusal(409, 'lessonRuns')
  const stop = new AbortController()
  const events = new EventStream(() => stop.abort())
  const outcome = ports.host.rehearse(body, (progress) => events.send('progress', progress), stop.signal)
  if (!outcome) throw new Refusal(409, 'rehearses')
  void outcome
    .then(
      (done) => events.send('done', done),
      (error: unknown) => {
        if (!stop.signal.aborted)
          ports.log({ method: 'POST', route: '/rehearsal', status: 500, error: codeOf(error) || 'failed' })
        events.send('failed', {})
      },
    )
    .finally(() => events.close())
  return Promise.resolve(events.response)
}

export const rehearsalRoutes: readonly Route[] = [route('POST', '/rehearsal', ['operator'], rehearse, wish)]

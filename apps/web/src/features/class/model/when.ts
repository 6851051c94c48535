import { ago } from '#words/ago.ts'
import { m } from '#words/message.ts'

/** When a version was saved: today by the clock, before by days. */
export function whenOf(time: number, now: number, locale: string): string {
  const day = (at: number) => new Date(at).toLocaleDateString('en-CA')
  if (day(time) !== day(now)) return ago(time, now, locale)
  const clock = new Date(time).toLocaleTimeString(locale, { hour: 'numeric', minute: '2-digit' })
  return m['class.today']({ time: clock })
}

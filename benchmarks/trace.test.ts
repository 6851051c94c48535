import { expect, test } from 'vitest'
import { mainThreadOf } from './trace.ts'

const on = (pid: number, tid: number) => ({ pid, tid })
const task = (dur: number) => ({ name: 'RunTask', ph: 'X', dur })
const named = (name: string) => ({ name: 'thread_name', ph: 'M', args: { name } })

test('only tasks of the page that draws count, in milliseconds; two pieces of code for a frame are one frame', () => {
  const events = [
    { ...named('CrRendererMain'), ...on(1, 7) },
    { ...named('CrRendererMain'), ...on(2, 7) },
    { ...named('Compositor'), ...on(1, 8) },
    { ...task(4000), ...on(1, 7) },
    { ...task(12_500), ...on(1, 7) },
    { ...task(99_000), ...on(1, 8) },
    { ...task(77_000), ...on(2, 7) },
    { name: 'FireAnimationFrame', ph: 'X', ...on(1, 7) },
    { name: 'FireAnimationFrame', ph: 'X', ...on(1, 7) },
    { name: 'Commit', ph: 'X', ...on(1, 7) },
  ]
  expect(mainThreadOf(JSON.stringify({ traceEvents: events }))).toEqual({ tasks: [4, 12.5], frames: 1 })
})

test('a trace without a page is refused', () => {
  expect(() => mainThreadOf('{"traceEvents":[]}')).toThrow('no page')
})

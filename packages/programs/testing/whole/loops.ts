import type { Block } from '@botgarten/blocks'
import { fieldOf } from './parts.ts'
import { Failure, type Steps, type WholeTwin } from './twin.ts'

export function* loop(twin: WholeTwin, block: Block): Steps<void> {
  const rows = block.statements?.DO
  switch (block.type) {
    case 'robControls_loopForever':
      while (yield* twin.pass(rows));
      return
    case 'controls_repeat':
    case 'controls_repeat_ext': {
      const isOld = block.type === 'controls_repeat'
      const times = isOld ? Number(fieldOf(block, 'TIMES')) : yield* twin.number(block, 'TIMES')
      for (let begun = 1; begun - 1 < times; begun++)
        if (!(yield* twin.pass(rows, () => begun >= times))) return
      return
    }
    case 'controls_whileUntil': {
      const goesOn = fieldOf(block, 'MODE') === 'WHILE'
      while (((yield* twin.ask(block, 'BOOL')) === true) === goesOn) if (!(yield* twin.pass(rows))) return
      return
    }
    case 'robControls_for': {
      const name = fieldOf(block, 'VAR')
      twin.make(name, yield* twin.number(block, 'FROM'))
      // What a pass makes of the variable counts.
      for (;;) {
        const to = yield* twin.number(block, 'TO')
        if (!(Number(twin.get(block, name)) < to)) return
        if (!(yield* twin.pass(rows))) return
        const by = yield* twin.number(block, 'BY')
        const next = Number(twin.get(block, name)) + by
        if (!Number.isFinite(next)) throw new Failure(block, 'tooBigNumber')
        twin.set(block, name, next)
      }
    }
    default: {
      const list = yield* twin.list(block, 'LIST')
      for (let k = 0; k < list.length; k++) {
        twin.make(fieldOf(block, 'VAR'), list[k]!)
        if (!(yield* twin.pass(rows, () => k + 1 >= list.length))) return
      }
    }
  }
}

/** Rules 7 and 24. */
export function* decide(twin: WholeTwin, block: Block): Steps<void> {
  const more = Number(block.mutation?.attrs.elseif ?? 0)
  for (let k = 0; k <= more; k++)
    if ((yield* twin.ask(block, `IF${k}`)) === true) return yield* twin.rows(block.statements?.[`DO${k}`])
  yield* twin.rows(block.statements?.ELSE)
}

/** Rule 23. */
export function* waitFor(twin: WholeTwin, block: Block): Steps<void> {
  const more = Number(block.mutation?.attrs.wait ?? 0)
  for (;;) {
    for (let k = 0; k <= more; k++)
      if ((yield* twin.ask(block, `WAIT${k}`)) === true) return yield* twin.rows(block.statements?.[`DO${k}`])
    yield 'tick'
  }
}

import type { Block, Value } from '@botgarten/blocks'
import type { LedColour, MotorPort, SensorPort } from '@botgarten/simulation'
import { drive } from './driving.ts'
import { decide, loop, waitFor } from './loops.ts'
import { biasOf, think, weightOf } from './net.ts'
import { network } from './network.ts'
import { between, fieldOf, percent } from './parts.ts'
import { Failure, Leaving, Returning, type Steps, type WholeTwin } from './twin.ts'
import { takeEntry, textOf } from './values.ts'

const whole = (x: number) => Math.floor(x + 0.5)

/** Rule 35. */
function* say(twin: WholeTwin, text: string, speed: number, pitch: number): Steps<void> {
  twin.host.robot.say(text, speed, pitch)
  yield* twin.wait(Math.max(500, text.length * 65 * (80 / (50 + speed))))
}

const tunes: readonly (readonly (readonly [hertz: number, ms: number])[])[] = [
  [
    [523, 150],
    [659, 150],
    [784, 300],
  ],
  [
    [784, 150],
    [659, 150],
    [523, 300],
  ],
  [
    [440, 100],
    [554, 100],
    [659, 100],
    [880, 300],
  ],
  [
    [330, 200],
    [330, 200],
    [262, 400],
  ],
  [
    [988, 80],
    [1319, 400],
  ],
]

/** Rule 27. */
function* putEntry(twin: WholeTwin, block: Block): Steps<void> {
  const list = yield* twin.list(block, 'LIST')
  const where = fieldOf(block, 'WHERE')
  const at = where.startsWith('FROM') ? Math.trunc(yield* twin.number(block, 'AT')) : 0
  const entry = yield* twin.ask(block, 'TO')
  const last = list.length - 1
  const place = { FROM_START: at, FROM_END: last - at, FIRST: 0, LAST: Math.max(last, 0) }[where as 'FIRST']
  if (place < 0) throw new Failure(block, 'noSuchEntry')
  if (fieldOf(block, 'MODE') === 'SET') {
    if (place > last) throw new Failure(block, list.length === 0 ? 'emptyList' : 'noSuchEntry')
    list[place] = entry
    return
  }
  if (list.length >= 10_000) throw new Failure(block, 'listTooLong')
  const before = where === 'LAST' ? list.length : place
  if (before > list.length) throw new Failure(block, 'noSuchEntry')
  list.splice(before, 0, entry)
  twin.costs(list.length)
}

/** Rule 39. */
function* assert(twin: WholeTwin, block: Block): Steps<void> {
  const text = (value: Value) => (typeof value === 'number' ? String(value) : textOf(value))
  const holds = (yield* twin.ask(block, 'OUT')) === true
  if (holds) twin.assertions.passed += 1
  else {
    const compares = block.values?.OUT?.type === 'logic_compare'
    const [expected, got] = compares ? twin.compared!.map(text) : ['true', 'false']
    twin.assertions.failed.push([fieldOf(block, 'TEXT'), expected!, got!])
  }
}

/** What a block in a row does. */
export function* execute(twin: WholeTwin, block: Block): Steps<void> {
  const { type } = block
  const { robot, mail } = twin.host
  const port = fieldOf(block, 'MOTORPORT') as MotorPort
  const sensorPort = fieldOf(block, 'SENSORPORT')
  if (/motorDiff_(on|turn|curve)/.test(type)) return yield* drive(twin, block)
  if (/loopForever|controls_repeat|whileUntil|robControls_for/.test(type)) return yield* loop(twin, block)
  switch (type) {
    case 'robControls_if':
    case 'robControls_ifElse':
      return yield* decide(twin, block)
    case 'robControls_wait':
    case 'robControls_wait_for':
      return yield* waitFor(twin, block)
    case 'robControls_wait_time':
      return yield* twin.wait(yield* twin.number(block, 'WAIT'))
    case 'controls_flow_statements':
      if (!twin.isInLoop) throw new Failure(block, 'notInLoop')
      throw new Leaving(fieldOf(block, 'FLOW') === 'BREAK' ? 'loop' : 'pass')
    case 'text_comment':
    case 'robSensors_compass_calibrate':
    case 'robActions_outputneuron_wo_var':
    case 'robActions_eval_stmt':
      return
    case 'robActions_motorDiff_stop':
      return robot.stop()
    case 'robActions_motor_on':
    case 'robActions_motor_setPower':
      return robot.motor(port, percent(yield* twin.number(block, 'POWER')))
    case 'robActions_motor_stop':
      return robot.motor(port, 0)
    case 'robActions_motor_on_for': {
      const power = percent(yield* twin.number(block, 'POWER'))
      const amount = yield* twin.number(block, 'VALUE')
      const degrees = fieldOf(block, 'MOTORROTATION') === 'DEGREE' ? amount : amount * 360
      robot.turn(port, degrees < 0 ? 0 - power : power, Math.abs(degrees))
      while (!robot.turned(port)) yield 'tick'
      return
    }
    case 'robActions_display_text': {
      const out = yield* twin.ask(block, 'OUT')
      const column = between(whole(yield* twin.number(block, 'COL')), 0, 16)
      return robot.display(between(whole(yield* twin.number(block, 'ROW')), 0, 7), column, textOf(out))
    }
    case 'robActions_display_clear':
      return robot.clearDisplay()
    case 'robActions_display_picture':
      yield* twin.number(block, 'X')
      yield* twin.number(block, 'Y')
      return robot.picture(fieldOf(block, 'PICTURE'))
    case 'robActions_display_picture_new':
      return robot.picture(fieldOf(block, 'PICTURE'))
    case 'actions_bricklight_on_ev3':
    case 'robActions_brickLight_on': {
      const colour = (fieldOf(block, 'COLOUR') || fieldOf(block, 'SWITCH_COLOR')).toLowerCase() as LedColour
      const mode = fieldOf(block, 'MODE') || fieldOf(block, 'SWITCH_BLINK')
      return mode === 'ON' ? robot.led(colour) : robot.led(colour, mode === 'FLASH' ? 'flash' : 'double')
    }
    case 'actions_bricklight_off_ev3':
    case 'robActions_brickLight_off':
    case 'robActions_brickLight_reset':
      return robot.led(null)
    case 'robActions_play_tone': {
      const hertz = Math.max(0, yield* twin.number(block, 'FREQUENCE'))
      const ms = Math.max(0, yield* twin.number(block, 'DURATION'))
      if (ms > 0) robot.tone(hertz, ms / 1000)
      return yield* twin.wait(ms)
    }
    case 'mbedActions_play_note': {
      const ms = Number(fieldOf(block, 'DURATION'))
      robot.tone(Number(fieldOf(block, 'FREQUENCE')), ms / 1000)
      return yield* twin.wait(ms)
    }
    case 'robActions_play_file':
      for (const [hertz, ms] of tunes[Number(fieldOf(block, 'FILE'))]!) {
        robot.tone(hertz, ms / 1000)
        yield* twin.wait(ms)
      }
      return
    case 'robActions_play_setVolume':
      return robot.setVolume(between(yield* twin.number(block, 'VOLUME'), 0, 100))
    case 'robActions_setLanguage':
      return robot.language(fieldOf(block, 'LANGUAGE'))
    case 'robActions_sayText':
      return yield* say(twin, textOf(yield* twin.ask(block, 'OUT')), 30, 50)
    case 'robActions_sayText_parameters': {
      const out = yield* twin.ask(block, 'OUT')
      const speed = between(yield* twin.number(block, 'VOICESPEED'), 0, 100)
      const pitch = between(yield* twin.number(block, 'VOICEPITCH'), 0, 100)
      return yield* say(twin, textOf(out), speed, pitch)
    }
    case 'robSensors_encoder_reset':
      return robot.resetEncoder(sensorPort as MotorPort)
    case 'robSensors_gyro_reset':
      if (robot.read(sensorPort as SensorPort, 'angle') === null) throw new Failure(block, 'nothingToRead')
      return robot.resetGyro(sensorPort as SensorPort)
    case 'robSensors_timer_reset':
      return robot.resetTimer(Number(sensorPort))
    case 'robActions_assert':
      return yield* assert(twin, block)
    case 'robActions_debug':
      return void twin.notes.push(textOf(yield* twin.ask(block, 'OUT')))
    case 'robGlobalVariables_declare':
      return twin.make(fieldOf(block, 'VAR'), yield* twin.ask(block, 'VALUE'))
    case 'variables_set':
      return twin.set(block, fieldOf(block, 'VAR'), yield* twin.ask(block, 'VALUE'))
    case 'robMath_change': {
      const delta = yield* twin.number(block, 'DELTA')
      const name = fieldOf(block.values!.VAR!, 'VAR')
      const sum = Number(twin.get(block, name)) + delta
      if (!Number.isFinite(sum)) throw new Failure(block, 'tooBigNumber')
      return twin.set(block, name, sum)
    }
    case 'robText_append': {
      const more = textOf(yield* twin.ask(block, 'TEXT'))
      const name = fieldOf(block.values!.VAR!, 'VAR')
      const longer = (twin.get(block, name) as string) + more
      if (longer.length > 10_000) throw new Failure(block, 'textTooLong')
      return twin.set(block, name, longer)
    }
    case 'robLists_setIndex':
      return yield* putEntry(twin, block)
    case 'robLists_getIndex':
      return void (yield* takeEntry(twin, block))
    case 'robProcedures_callnoreturn':
      return void (yield* twin.call(block))
    case 'robProcedures_ifreturn': {
      if ((yield* twin.ask(block, 'CONDITION')) !== true) return
      const value = block.mutation?.attrs.value === '1' ? yield* twin.ask(block, 'VALUE') : null
      if (!twin.isInFunction) throw new Failure(block, 'notInFunction')
      throw new Returning(value)
    }
    case 'robCommunication_sendBlock': {
      const data = yield* twin.ask(block, 'sendData')
      const to = yield* twin.ask(block, 'CONNECTION')
      if (typeof to !== 'string') throw new Failure(block, 'notConnected')
      return mail?.send(to, { kind: 'text', text: textOf(data) })
    }
    case 'ai_neural_network':
      return yield* network(twin, block)
    default:
      return yield* byName(twin, block)
  }
}

/** Rule 38. */
function* byName(twin: WholeTwin, block: Block): Steps<void> {
  const { type } = block
  const increases = fieldOf(block, 'CHANGE') === 'INCR'
  switch (type) {
    case 'robActions_NNstep':
      yield* twin.rows(block.statements?.IONEURON)
      return think(twin, block)
    case 'robActions_set_inputneuron_val':
    case 'robActions_inputneuron':
      return void twin.net.inputs.set(fieldOf(block, 'NAME'), yield* twin.number(block, 'VALUE'))
    case 'robActions_outputneuron': {
      think(twin, block)
      const value = twin.net.outputs.get(fieldOf(block, 'NAME')) ?? 0
      return twin.set(block, fieldOf(block.values!.VALUE!, 'VAR'), value)
    }
    case 'robActions_set_weight':
    case 'robActions_change_weight': {
      const value = yield* twin.number(block, 'VALUE')
      const before = weightOf(twin, block)
      const link = `${fieldOf(block, 'FROM')} ${fieldOf(block, 'TO')}`
      return void twin.net.weights.set(link, increases ? before + value : value)
    }
    case 'robActions_set_bias':
    case 'robActions_change_bias': {
      const value = yield* twin.number(block, 'VALUE')
      const before = biasOf(twin, block)
      return void twin.net.biases.set(fieldOf(block, 'NAME'), increases ? before + value : value)
    }
    default:
      throw new Failure(block, 'unknownBlock')
  }
}

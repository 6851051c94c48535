import type { Block, Host, Value } from '@botgarten/blocks'

/** What the interpreter does, told again as plainly as can be: one generator a block, one `yield` where time may pass. */
type Pause = 'block' | 'tick'
type Steps<T> = Generator<Pause, T, void>

class Failure extends Error {
  readonly block: string
  readonly problem: string
  constructor(block: Block, problem: string) {
    super(problem)
    this.block = block.id
    this.problem = `problem.${problem}`
  }
}

/** Runs a stack tick by tick. Slow and obvious: for tests only. */
export class Twin {
  ended = false
  problem: Failure | null = null
  lit: string | null = null
  readonly #steps: Steps<void>
  readonly #context: Host
  #acts = 0
  #spent = 1

  constructor(stack: readonly Block[], context: Host) {
    this.#context = context
    this.#steps = this.#rows(stack.slice(1))
  }

  tick(): void {
    if (this.ended) return
    try {
      if (this.#untilTickIsOver()) return
    } catch (failure) {
      if (!(failure instanceof Failure)) throw failure
      this.problem = failure
    }
    this.ended = true
    this.lit = null
    this.#context.robot.stop()
    this.#context.robot.tone(0, null)
  }

  #untilTickIsOver(): boolean {
    for (;;) {
      const { done, value } = this.#steps.next()
      if (done) return false
      this.#spent = value === 'tick' ? 0 : this.#spent + 1
      if (value === 'tick') return true
      if (this.#spent > 1000) {
        this.#spent = 1
        return true
      }
    }
  }

  *#rows(rows: readonly Block[] = []): Steps<void> {
    for (const block of rows) if (block.disabled !== true) yield* this.#statement(block)
  }

  *#statement(block: Block): Steps<void> {
    const acting = !/^robControls|^controls/.test(block.type)
    if (acting) this.#acts++
    this.lit = block.id
    yield 'block'
    yield* this.#meaning(block)
  }

  *#meaning(block: Block): Steps<void> {
    const { robot } = this.#context
    switch (block.type) {
      case 'robControls_loopForever':
        for (;;) {
          const acts = this.#acts
          yield* this.#rows(block.statements?.DO)
          yield this.#acts > acts ? 'tick' : 'block'
        }
      case 'controls_repeat_ext':
        return yield* this.#repeat(block)
      case 'robControls_wait_time':
        return yield* this.#wait(yield* this.#number(block, 'WAIT'))
      case 'robControls_if':
      case 'robControls_ifElse': {
        const condition = yield* this.#value(block, 'IF0')
        return yield* this.#rows(block.statements?.[condition === true ? 'DO0' : 'ELSE'])
      }
      case 'robActions_motorDiff_on': {
        const speed = signed(yield* this.#number(block, 'POWER'), block)
        return robot.move({ left: speed, right: speed })
      }
      case 'robActions_motorDiff_on_for':
        return yield* this.#drive(block)
      case 'robActions_motorDiff_turn_for':
        return yield* this.#turn(block)
      case 'robActions_motor_on': {
        const speed = cut(yield* this.#number(block, 'POWER'))
        return robot.motor(block.fields?.MOTORPORT as 'B', speed)
      }
      case 'robActions_motorDiff_stop':
        return robot.stop()
      case 'robActions_display_text':
        return yield* this.#show(block)
      case 'actions_bricklight_on_ev3':
        return robot.led('red')
      case 'robActions_play_tone': {
        const frequency = Math.max(0, yield* this.#number(block, 'FREQUENCE'))
        const duration = Math.max(0, yield* this.#number(block, 'DURATION'))
        if (duration > 0) robot.tone(frequency, duration / 1000)
        return yield* this.#wait(duration)
      }
      case 'ai_neural_network':
        return yield* this.#net(block)
      default:
        throw new Failure(block, 'unknownBlock')
    }
  }

  *#repeat(block: Block): Steps<void> {
    const times = yield* this.#number(block, 'TIMES')
    for (let pass = 0; pass < times; pass++) {
      const acts = this.#acts
      yield* this.#rows(block.statements?.DO)
      if (pass + 1 < times) yield this.#acts > acts ? 'tick' : 'block'
    }
  }

  *#wait(milliseconds: number): Steps<void> {
    for (let ticks = 0; ticks * 1000 < milliseconds * 60 - 1e-6; ticks++) yield 'tick'
  }

  *#drive(block: Block): Steps<void> {
    const power = signed(yield* this.#number(block, 'POWER'), block)
    const distance = yield* this.#number(block, 'DISTANCE')
    const speed = distance < 0 ? 0 - power : power
    yield* this.#move(speed, speed, (Math.abs(distance) / (Math.PI * 5.6)) * 360)
  }

  *#turn(block: Block): Steps<void> {
    const power = signed(yield* this.#number(block, 'POWER'), block)
    const angle = yield* this.#number(block, 'DEGREE')
    const speed = angle < 0 ? 0 - power : power
    yield* this.#move(speed, 0 - speed, (Math.abs(angle) * 18) / 5.6)
  }

  *#move(left: number, right: number, degrees: number): Steps<void> {
    const { robot } = this.#context
    if (left === 0 || degrees === 0) return robot.move({ left: 0, right: 0 })
    robot.move({ left, right, degrees })
    while (!robot.arrived()) yield 'tick'
  }

  *#show(block: Block): Steps<void> {
    const out = yield* this.#value(block, 'OUT')
    const column = yield* this.#number(block, 'COL')
    const row = yield* this.#number(block, 'ROW')
    const place = (x: number, last: number) => Math.min(Math.max(Math.round(x), 0), last) + 0
    this.#context.robot.display(place(row, 7), place(column, 16), String(Number(Number(out).toFixed(4)) + 0))
  }

  *#net(block: Block): Steps<void> {
    const inputs: number[] = []
    for (const row of yield* this.#layer(block, 'INPUT_LAYER')) inputs.push(Number(yield* this.#any(row)))
    const outputs = this.#context.think(block.id, inputs)
    const motors: [string, number][] = []
    for (const row of yield* this.#layer(block, 'OUTPUT_LAYER')) {
      yield 'block'
      motors.push([row.fields?.OUTPUTNODE?.slice(-1) ?? '', outputs[motors.length] ?? 0])
    }
    for (const [port, level] of motors) this.#context.robot.motor(port as 'B', cut(level))
  }

  *#layer(block: Block, name: string): Steps<readonly Block[]> {
    const list = block.values?.[name]
    if (!list) return []
    yield 'block'
    return Object.values(list.values ?? {}).filter(({ disabled }) => disabled !== true)
  }

  *#value(block: Block, input: string): Steps<Value> {
    const child = block.values?.[input]
    if (!child || child.disabled === true) throw new Failure(block, 'missingValue')
    return yield* this.#any(child)
  }

  *#number(block: Block, input: string): Steps<number> {
    return Number(yield* this.#value(block, input))
  }

  *#any(block: Block): Steps<Value> {
    if (/Sensors|input_node/.test(block.type)) this.#acts++
    yield 'block'
    switch (block.type) {
      case 'math_number':
        return Number(block.fields?.NUM) + 0
      case 'math_arithmetic':
        return this.#calculate(block, yield* this.#number(block, 'A'), yield* this.#number(block, 'B'))
      case 'logic_compare': {
        const a = yield* this.#number(block, 'A')
        const b = yield* this.#number(block, 'B')
        return { EQ: a === b, NEQ: a !== b, LT: a < b, LTE: a <= b, GT: a > b, GTE: a >= b }[
          block.fields?.OP as 'EQ'
        ]
      }
      case 'robSensors_ultrasonic_getSample':
        return this.#read(block, 'SENSORPORT')
      case 'ai_nn_input_node_ultrasonic':
        return Math.min(100, this.#read(block, 'INPUTNODE'))
      default:
        throw new Failure(block, 'unknownBlock')
    }
  }

  #read(block: Block, field: string): number {
    const port = block.fields?.[field]?.slice(-1)
    const reading = this.#context.robot.read(port as '1', 'distance')
    if (reading === null) throw new Failure(block, 'nothingToRead')
    return Number(reading)
  }

  #calculate(block: Block, a: number, b: number): number {
    const operator = block.fields?.OP as 'ADD'
    if (operator === ('DIVIDE' as string) && b === 0) throw new Failure(block, 'divisionByZero')
    const result = { ADD: a + b, MINUS: a - b, MULTIPLY: a * b, DIVIDE: a / b }[operator]
    if (!Number.isFinite(result)) throw new Failure(block, 'tooBigNumber')
    return result + 0
  }
}

const cut = (x: number) => Math.min(100, Math.max(-100, x)) + 0

function signed(power: number, block: Block): number {
  const speed = cut(power)
  return /BACKWARD|LEFT/.test(block.fields?.DIRECTION ?? '') ? 0 - speed : speed
}

import type { Block } from '@botgarten/blocks'
import type { Project } from '@botgarten/programs'
import { freeProgram } from './projects.ts'
import { Blocks } from './runs/blocks.ts'

const text = (make: Blocks, TEXT: string) => make.block('text', { fields: { TEXT } })

/** The project, and in its first program blocks that hang on nothing. */
function withLoose(project: Project, loose: readonly Block[]): string {
  const main = project.programs['main']!
  const stacks = loose.map((block, at) => ({ x: 40, y: 160 + at * 70, blocks: [block] }))
  return JSON.stringify({
    ...project,
    programs: { ...project.programs, main: { ...main, stacks: [...main.stacks, ...stacks] } },
  })
}

/** A robot that waits (`b4`) for as long as a number says (`b3`), and beside it a text (`b1`) and a number (`b2`). */
export function besides(): string {
  const make = new Blocks()
  const loose = [text(make, 'Bo'), make.number(7)]
  const project = JSON.parse(freeProgram('Beside', () => [])) as Project
  return withLoose({ ...project, programs: { main: make.program(make.wait(500)) } }, loose)
}

/** Bo 1 sends (`b5`) a word (`b2`), Bo 2 shows what comes; beside lies another word, `tok` (`b1`). */
export function friends(): string {
  const make = new Blocks()
  const [tok, tik] = [text(make, 'tok'), text(make, 'tik')]
  const said = {
    mutation: { attrs: { datatype: 'String' } },
    fields: { TYPE: 'String', PROTOCOL: 'BLUETOOTH', CHANNEL: '-1' },
  }
  const call = make.block('robCommunication_startConnection', { values: { ADDRESS: text(make, 'Bo 2') } })
  const send = make.block('robCommunication_sendBlock', {
    ...said,
    values: { sendData: tik, CONNECTION: call },
  })
  const called = make.block('robCommunication_waitForConnection')
  const came = make.block('robCommunication_receiveBlock', { ...said, values: { CONNECTION: called } })
  const show = make.block('robActions_display_text', {
    values: { OUT: came, COL: make.number(0), ROW: make.number(0) },
  })
  const { world, ...project } = JSON.parse(freeProgram('Friends', () => [])) as Project
  const [bo] = world.robots
  const robots = [bo!, { ...bo!, id: 'bo2', pose: { x: 60, y: 60, heading: 90 }, program: 'other' }]
  const programs = { main: make.program(send), other: make.program(show) }
  return withLoose({ ...project, programs, world: { ...world, robots } }, [tok])
}

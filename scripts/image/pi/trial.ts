// A system that came by an update tries itself on a copy of the data, before it answers anybody: only if the lab starts
// there does it stay. Else the Pi starts the system before, whose data nobody has touched.
import { spawn, type ChildProcess } from 'node:child_process'
import { chownSync, cpSync, readdirSync, rmSync } from 'node:fs'
import { join } from 'node:path'
import { setTimeout as after } from 'node:timers/promises'
import {
  data,
  here,
  lab,
  labUser,
  overwrite,
  readBoot,
  run,
  settings,
  show,
  textIn,
  writeBoot,
} from './machine.ts'
import { readTrial, slotLine, taskOf, trialLine, type Trial } from './slots.ts'
import { say } from './text.ts'

const copy = `${data}/trial`
const site = 'http://127.0.0.1:4199'
/** A Pi Zero takes half a minute to start the lab, and some more to change the tables of its database. */
const seconds = 300

function copyData() {
  rmSync(copy, { recursive: true, force: true })
  cpSync(lab, copy, { recursive: true, filter: (path) => path !== join(lab, 'backups') })
  for (const file of ['.', ...readdirSync(copy, { recursive: true, encoding: 'utf8' })])
    chownSync(join(copy, file), labUser, labUser)
}

const startLab = () =>
  spawn('/opt/botgarten/botgarten.sh', ['serve', '--port', '4199', '--host', '127.0.0.1'], {
    env: { PATH: '/usr/bin:/bin', HOME: copy, BOTGARTEN_DATA: copy },
    ...{ uid: labUser, gid: labUser, stdio: ['ignore', 'ignore', 'inherit'] as const },
  })

const isThere = async (path: string) => (await fetch(site + path).catch(() => null))?.status === 200

async function answers(running: ChildProcess): Promise<boolean> {
  let gone = false
  running.once('error', () => (gone = true))
  running.once('exit', () => (gone = true))
  for (let second = 0; second < seconds && !gone; second++) {
    if ((await isThere('/')) && (await isThere('/api/class/state'))) return true
    await after(1000)
  }
  return false
}

async function passes(): Promise<boolean> {
  try {
    copyData()
    const running = startLab()
    const passed = await answers(running)
    running.kill('SIGKILL')
    return passed
  } catch (error) {
    console.error(error)
    return false
  } finally {
    rmSync(copy, { recursive: true, force: true })
  }
}

const note = (state: Trial['state'], { slot }: Trial) =>
  writeBoot((folder) => {
    if (state === 'kept') overwrite(folder, 'slot.txt', slotLine(slot))
    overwrite(folder, 'trial.txt', trialLine({ state, slot }).padEnd(12))
  })

const trial = readTrial(readBoot((folder) => textIn(join(folder, 'trial.txt'))) ?? '')
const task = taskOf(here.slot, trial)
if (task === 'failed') note('failed', trial!)
if (task === 'try') {
  show(`Botgarten\n\n${say(settings().language, 'trying')}\n`)
  if (await passes()) note('kept', trial!)
  else {
    note('failed', trial!)
    run('systemctl', 'reboot')
    // The lab waits for this program; the restart ends it.
    await after(600_000)
  }
}

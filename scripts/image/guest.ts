import { execFileSync, spawn, type ChildProcess } from 'node:child_process'
import { once } from 'node:events'
import { createWriteStream, mkdirSync, readFileSync, rmSync } from 'node:fs'
import { connect } from 'node:net'
import { join } from 'node:path'
import { setTimeout as after } from 'node:timers/promises'
import { stripVTControlCharacters } from 'node:util'
import { Trouble } from '../prepare/run.mjs'
import { mib, partitions, place, sector } from './partitions.ts'

/** A card of which a Pi's firmware would start, in a machine without one. */
export interface Card {
  readonly file: string
  /** For what is taken out of it. */
  readonly work: string
  /** At which port of this machine the lab answers. */
  readonly port: number
  /** What the clock says when the machine is switched on, ms since 1970; not given: this machine's. */
  readonly clock?: number
}

const bootAt = (place(partitions)[0]!.start * sector) / mib

/** A file of the boot partition, read from outside; null: there is none. */
export function fromBoot({ file }: Card, path: string): string | null {
  try {
    return execFileSync('mtype', ['-i', `${file}@@${bootAt}M`, `::/${path}`], {
      encoding: 'utf8',
      stdio: ['ignore', 'pipe', 'ignore'],
    })
  } catch {
    return null
  }
}

/** Copies a file onto the boot partition, as another computer does. */
export function toBoot({ file }: Card, from: string, path: string): void {
  execFileSync('mcopy', ['-o', '-i', `${file}@@${bootAt}M`, from, `::/${path}`])
}

/** Stands in for the firmware: takes what slot.txt names out of the boot partition. */
function load(card: Card): { readonly slot: string; readonly append: string } {
  const slot = /^os_prefix=([ab])\/$/m.exec(fromBoot(card, 'slot.txt') ?? '')?.[1]
  if (slot === undefined) throw new Trouble('slot.txt names no system.')
  for (const name of ['vmlinuz', 'initrd.img', 'cmdline.txt'])
    execFileSync('mcopy', ['-o', '-i', `${card.file}@@${bootAt}M`, `::/${slot}/${name}`, card.work])
  return { slot, append: readFileSync(join(card.work, 'cmdline.txt'), 'utf8').trim() }
}

export interface Guest {
  /** From which of the two systems it was started. */
  readonly slot: string
  /** Runs a command as root by a shell that exists in the test alone, and gives what it wrote. */
  shell(command: string): Promise<string>
  /** A word to QEMU's monitor, and what it answered. */
  monitor(command: string): Promise<string>
  /** Stands still, writes its memory into a file and ends; `goOn` continues there. */
  freeze(memory: string): Promise<void>
  /** Pulls the plug. */
  cut(): Promise<void>
  /** Has ended by itself: the guest started again. */
  readonly ended: Promise<void>
  /** All that it wrote on its serial line. */
  output(): string
}

function machine({ file, work, port, clock }: Card, append: string, memory: string | null): string[] {
  // A root shell on the serial line, by the kernel's command line alone: the image holds no way in.
  const forTest =
    'console=ttyAMA0 systemd.debug_shell systemd.default_debug_tty=ttyAMA0 systemd.default_device_timeout_sec=900'
  return [
    ...[
      '-machine',
      'virt',
      '-cpu',
      'cortex-a72',
      '-smp',
      '1',
      '-m',
      '1024',
      '-no-reboot',
      '-display',
      'none',
    ],
    ...[
      '-kernel',
      join(work, 'vmlinuz'),
      '-initrd',
      join(work, 'initrd.img'),
      '-append',
      `${append} ${forTest}`,
    ],
    ...['-drive', `if=none,id=card,file=${file},format=raw,cache=writeback`],
    ...['-device', 'virtio-blk-pci,drive=card', '-device', 'virtio-gpu-pci', '-device', 'qemu-xhci'],
    ...[
      '-netdev',
      `user,id=net,hostfwd=tcp:127.0.0.1:${port}-:80`,
      '-device',
      'virtio-net-pci,netdev=net,romfile=',
    ],
    ...(clock === undefined ? [] : ['-rtc', `base=${new Date(clock).toISOString().slice(0, 19)},clock=vm`]),
    ...['-monitor', `unix:${join(work, 'monitor')},server=on,wait=off`],
    ...['-chardev', 'stdio,id=serial,signal=off', '-serial', 'chardev:serial'],
    ...(memory === null ? [] : ['-incoming', `exec:cat '${memory}'`]),
  ]
}

async function say(socket: string, command: string): Promise<string> {
  const line = connect(socket)
  let text = ''
  line.on('data', (part) => (text += String(part)))
  await once(line, 'connect')
  line.write(`${command}\n`)
  await after(500)
  line.end()
  return text
}

/** Asks the monitor until it says so. */
async function untilSaid(monitor: Guest['monitor'], command: string, answer: RegExp) {
  for (let tries = 0; tries < 300; tries++) {
    if (answer.test(await monitor(command).catch(() => ''))) return
    await after(1000)
  }
  throw new Trouble(`QEMU: ${command}`)
}

let asked = 0
const started = new Set<ChildProcess>()
process.once('exit', () => started.forEach((running) => running.kill('SIGKILL')))

/** Words that stand in an answer only, not in the echo of what was asked. */
async function ask(running: ChildProcess, output: () => string, command: string): Promise<string> {
  const mark = `m${++asked}`
  running.stdin!.write(`printf '%s%s\\n' beg ${mark}; { ${command}; } 2>&1; printf '%s%s\\n' end ${mark}\n`)
  for (let tries = 0; tries < 1200; tries++) {
    const found = new RegExp(`beg${mark}\\r?\\n([^]*?)end${mark}`).exec(output())
    // A shell on a line that looks like a terminal: some programs write in colours.
    if (found) return stripVTControlCharacters(found[1]!).replaceAll('\r', '').trim()
    await after(250)
  }
  throw new Trouble(`The guest did not answer: ${command}\n${output().slice(-2000)}`)
}

/**
 * Starts the card in QEMU's machine `virt`: the same kernel, first root and root as on a Pi.
 * @param memory what `freeze` wrote, of a machine with this card; null: it is switched on
 */
export function startGuest(card: Card, memory: string | null = null): Guest {
  mkdirSync(card.work, { recursive: true })
  rmSync(join(card.work, 'monitor'), { force: true })
  const { slot, append } = load(card)
  const running = spawn('nice', ['-n', '0', 'qemu-system-aarch64', ...machine(card, append, memory)], {
    stdio: ['pipe', 'pipe', 'inherit'],
  })
  let text = ''
  const log = createWriteStream(join(card.work, 'serial.txt'))
  running.stdout.on('data', (part) => {
    text += String(part)
    log.write(part)
  })
  running.stdin.on('error', () => {})
  const ended = once(running, 'exit').then(() => {})
  started.add(running)
  void ended.then(() => started.delete(running))
  const output = () => text
  const monitor = (command: string) => say(join(card.work, 'monitor'), command)
  const cut = async () => {
    running.kill('SIGKILL')
    await ended
  }
  return {
    ...{ slot, ended, output, monitor, cut },
    shell: (command) => ask(running, output, command),
    async freeze(file) {
      await monitor('stop')
      await monitor(`migrate -d "exec:cat > '${file}'"`)
      await untilSaid(monitor, 'info migrate', /status: completed/)
      await cut()
    },
  }
}

/** Continues where a machine with this card was frozen. */
export async function goOn(card: Card, memory: string): Promise<Guest> {
  const guest = startGuest(card, memory)
  await untilSaid((word) => guest.monitor(word), 'info status', /status: (running|paused(?! \(inmigrate))/)
  await guest.monitor('cont')
  return guest
}

/** @throws after half an hour, with the last lines of the guest */
export async function untilLabAnswers({ port }: Card, guest: Guest): Promise<number> {
  const began = Date.now()
  let gone = false
  void guest.ended.then(() => (gone = true))
  while (!gone && Date.now() - began < 1_800_000) {
    const answer = await fetch(`http://127.0.0.1:${port}/api/class/state`).catch(() => null)
    if (answer?.status === 200) return Math.round((Date.now() - began) / 1000)
    await after(1000)
  }
  throw new Trouble(`The lab did not answer.\n${guest.output().slice(-4000)}`)
}

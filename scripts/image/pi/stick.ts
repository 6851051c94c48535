// A USB stick was put in: an update on it goes to the other system, if a teacher has put its checksum beside it.
import { createHash } from 'node:crypto'
import { createReadStream, mkdirSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { execFileSync } from 'node:child_process'
import { here, overwrite, readBoot, run, settings, show, textIn, writeBoot } from './machine.ts'
import { fill, other, partitionOf, slotLine, trialLine } from './slots.ts'
import { say, type Word } from './text.ts'
import { consentFile, decide } from './update.ts'

const stick = process.argv[2]!
const target = other(here.slot)
const folder = '/run/botgarten/stick'
const linkFile = 'first-teacher.txt'

const tell = (word: Word) => show(`Botgarten\n\n${say(settings().language, word)}\n`)

/** Also for who looks at the stick at home. */
function report(word: Word) {
  tell(word)
  run('mount', '-o', 'remount,rw', folder)
  const both = (['de', 'en'] as const).map((language) => say(language, word)).join('\r\n')
  writeFileSync(join(folder, 'botgarten.txt'), `${both}\r\n`)
  run('mount', '-o', 'remount,ro', folder)
}

/** Without a screen: a stick that brings an empty `first-teacher.txt` takes the link with it. */
function giveLink() {
  const [asked, link] = [join(folder, linkFile), readBoot((boot) => textIn(join(boot, linkFile)))]
  if (link === null || textIn(asked)?.trim() !== '') return
  run('mount', '-o', 'remount,rw', folder)
  writeFileSync(asked, link)
  run('mount', '-o', 'remount,ro', folder)
}

async function sha256Of(file: string): Promise<string> {
  const hash = createHash('sha256')
  for await (const part of createReadStream(file)) hash.update(part as Buffer)
  return hash.digest('hex')
}

/** The root goes straight onto its partition; kernel and first root into the folder of the other system. */
function install(file: string, sha256: string) {
  const device = `/dev/disk/by-partuuid/${here.disk}-${partitionOf[target]}`
  const write =
    'set -o pipefail; tar -xOf "$1" root.img.zst | zstd -dc | dd of="$2" bs=4M conv=fsync status=none'
  execFileSync('bash', ['-c', write, 'write', file, device], { stdio: 'inherit' })
  run('e2fsck', '-fn', device)
  writeBoot((boot) => {
    const place = join(boot, target)
    rmSync(place, { recursive: true, force: true })
    mkdirSync(place)
    run('tar', '-xf', file, '-C', place, '--no-same-owner', '--exclude=root.img.zst')
    const template = textIn(join(place, 'cmdline.txt'))!
    writeFileSync(join(place, 'cmdline.txt'), fill(template, here.disk, target))
    writeFileSync(join(place, 'update.txt'), `${sha256}\n`)
    // All of it is on the card before anything of it is started.
    run('sync')
    overwrite(boot, 'trial.txt', trialLine({ state: 'wanted', slot: target }).padEnd(12))
    overwrite(boot, 'slot.txt', slotLine(target))
  })
}

const known = () =>
  readBoot((boot) => ['a', 'b'].map((slot) => textIn(join(boot, slot, 'update.txt'))?.trim() ?? ''))

async function look() {
  const decision = decide({
    files: readdirSync(folder),
    consent: textIn(join(folder, consentFile)),
    known: known(),
  })
  if (decision.do === 'nothing') return
  if (decision.do !== 'install') return report(decision.do)
  const file = join(folder, decision.file)
  tell('installing')
  if ((await sha256Of(file)) !== decision.sha256) return report('broken')
  try {
    install(file, decision.sha256)
  } catch (error) {
    console.error(error)
    return report('notInstalled')
  }
  run('systemctl', 'reboot')
}

const isOwn = readBoot(
  () =>
    execFileSync('findmnt', ['-no', 'SOURCE', '/run/botgarten/mounted'], { encoding: 'utf8' }).trim() ===
    stick,
)
if (!isOwn) {
  mkdirSync(folder, { recursive: true })
  run('mount', '-o', 'ro,nodev,nosuid,noexec', stick, folder)
  try {
    giveLink()
    await look()
  } finally {
    run('umount', folder)
  }
}

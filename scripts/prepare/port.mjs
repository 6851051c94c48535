import { parseArgs } from 'node:util'
import { Trouble } from './run.mjs'

const usual = 4173

/** @param {readonly string[]} args of the command line @returns {number} */
export function portFrom(args) {
  const port = Number(read(args) ?? usual)
  if (Number.isInteger(port) && port >= 0 && port <= 65535) return port
  throw new Trouble('A port is a whole number from 0 to 65535, as in: npm start -- --port 8080')
}

function read(args) {
  try {
    return parseArgs({ args: [...args], options: { port: { type: 'string' } } }).values.port
  } catch {
    throw new Trouble('npm start knows one option: npm start -- --port 8080')
  }
}

// Where tools and tests, also of other checkouts, find the server.
export { startServer, type RunningServer } from '../packages/server/index.ts'

// In WebKit a worker's own script, imported once more by what it loads later, is another module: it holds nothing.
import './trial-thread'
